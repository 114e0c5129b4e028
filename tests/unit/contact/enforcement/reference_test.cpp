// SPDX-License-Identifier: Apache-2.0
// The reference solve on closed contact.
#include "contact/enforcement/reference.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("the reference solves rows that hold both ways by conjugate gradients") {
  Problem p = patch(10, 7, 1, 1);
  for (Row& row : p.rows) row.cone = Cone::free;
  const EnforcementResult result = p.solve({.method = Method::reference});
  CHECK(result.residual < 1e-9);
  for (std::size_t q = 0; q < p.rows.size(); ++q) CHECK(std::abs(p.rate(q)) < 1e-9);
}
