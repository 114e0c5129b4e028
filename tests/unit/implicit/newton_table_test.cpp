// SPDX-License-Identifier: Apache-2.0
#include "implicit/newton_table.hpp"

#include <catch2/catch.hpp>

using namespace brunt::implicit;

TEST_CASE("a step is judged by its last two residuals above rounding, if its set stood over them") {
  // two rows of M6 in reference-mortar.md: log 2.2e-9 / log 1.4e-4, log 3.7e-6 / log 1.1e-2
  CHECK(order_of(std::vector<double>{6.3e-2, 1.4e-4, 2.2e-9, 2e-13}) == Approx(2.246).epsilon(1e-3));
  CHECK(order_of(std::vector<double>{1.1e-2, 3.7e-6, 9e-13}) == Approx(2.773).epsilon(1e-3));
  CHECK(order_of(std::vector<double>{1e-2, 1e-12}) == 0);
  NewtonTable table;
  add(table, {0.1, {6.3e-2, 1.4e-4, 2.2e-9, 2e-13}, true});
  add(table, {0.2, {6.3e-2, 1.4e-4, 2.2e-9, 2e-13}, false});  // the set changed
  add(table, {0.3, {1e-1, 1e-2, 1e-3, 1e-4}, true});          // linear
  add(table, {0.4, {1e-2, 1e-12}, true});                     // nothing to judge
  CHECK(table.judged == 2);
  CHECK(table.quadratic == 1);
  CHECK(table.last.size() == 4);
  for (std::size_t k = 0; k < most_records; ++k) add(table, {1, {1e-2, 1e-4}, true});
  CHECK(table.last.size() == most_records);
  CHECK(table.judged == 2 + static_cast<brunt::GlobalIndex>(most_records));
}
