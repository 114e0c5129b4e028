// SPDX-License-Identifier: Apache-2.0
// All ways to the rate constraint end at one solution.
#include "contact/enforcement/enforce.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

double largest_difference(const Problem& a, const Problem& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.velocity.size(); ++n)
    largest = std::max(largest, (a.velocity[n] - b.velocity[n]).norm());
  return largest;
}

}  // namespace

TEST_CASE("all rate methods end at the exact solution") {
  const int scene = GENERATE(0, 1, 2, 3);
  Problem exact = scene == 0   ? patch(20, 13, 1, 1)
                  : scene == 1 ? patch(8, 12, 1, 1)
                  : scene == 2 ? patch(20, 13, 1, 0.1)
                               : random_patch(3);
  const EnforcementResult reference = exact.solve({.method = Method::reference});
  CHECK(reference.residual < 1e-8);
  for (const Method method : {Method::rate, Method::row_sum}) {
    Problem p = exact;
    const EnforcementResult result = p.solve({.method = method, .tolerance = 1e-10, .max_iterations = 100000});
    CHECK(result.residual <= 1e-10);
    CHECK(largest_difference(p, exact) < 1e-6);
  }
}
