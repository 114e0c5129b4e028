// SPDX-License-Identifier: Apache-2.0
#include "model/curve.hpp"

#include <catch2/catch.hpp>

using namespace brunt;

TEST_CASE("the integral of a curve is that of its straight pieces, constant beyond its ends") {
  const model::Curve curve{{1, 2}, {3, 6}, {4, -2}};
  CHECK(model::integral(curve, 1, 3) == Approx(8));
  CHECK(model::integral(curve, 0, 1) == Approx(2));
  CHECK(model::integral(curve, 4, 6.5) == Approx(-5));
  CHECK(model::integral(curve, 0.5, 5) == Approx(1 + 8 + 2 - 2));
  CHECK(model::integral(curve, 2, 2) == 0);
  CHECK(model::integral({}, 2, 5) == Approx(3));
  double sum = 0;
  for (int i = 0; i < 100; ++i) sum += model::integral(curve, 0.05 * i, 0.05 * (i + 1));
  CHECK(sum == Approx(model::integral(curve, 0, 5)).epsilon(1e-13));
}
