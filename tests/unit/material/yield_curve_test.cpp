// SPDX-License-Identifier: Apache-2.0
#include "material/yield_curve.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"

using brunt::InputError;
using brunt::material::YieldCurve;

TEST_CASE("yield stress between, at and beyond the points of the table") {
  const YieldCurve curve({{0, 10}, {1, 20}, {3, 16}}, 100);
  CHECK(curve.at(0) == 10);
  CHECK(curve.at(0.25) == 12.5);
  CHECK(curve.at(1) == 20);
  CHECK(curve.at(2) == 18);
  CHECK(curve.at(7) == 16);
  CHECK(curve.initial() == 10);
  CHECK(curve.smallest() == 10);
  CHECK(YieldCurve({{0, 5}}, 1).at(3) == 5);
}

TEST_CASE("the return equation holds wherever the step starts and ends") {
  const double shear = 2;
  const YieldCurve curve({{0, 10}, {1, 20}, {3, 16}, {4, 40}}, shear);
  for (const double start : {0.0, 0.3, 1.0, 2.9, 3.0, 4.0, 9.0})
    for (const double excess : {0.0, 1e-9, 0.5, 8.0, 16.0, 50.0, 1000.0}) {
      const double d = curve.plastic_increment(start, excess);
      CHECK(d >= 0);
      CHECK(3 * shear * d + curve.at(start + d) - curve.at(start) == Approx(excess).epsilon(1e-12).margin(1e-13));
    }
}

TEST_CASE("the slope of the curve is that of the piece beyond, none beyond the last point") {
  const YieldCurve curve({{0, 10}, {1, 20}, {3, 16}}, 2);
  CHECK(curve.slope_at(0) == 10);
  CHECK(curve.slope_at(0.9) == 10);
  CHECK(curve.slope_at(1) == -2);
  CHECK(curve.slope_at(3) == 0);
  CHECK(curve.slope_at(9) == 0);
}

TEST_CASE("a table that is no hardening curve is refused, one line a fault") {
  const auto faults = [](std::vector<std::array<double, 2>> table) -> std::size_t {
    try {
      YieldCurve(table, 1.0);
    } catch (const InputError& error) {
      return error.faults().size();
    }
    return 0;
  };
  CHECK(faults({{0, 1}, {1, 2}}) == 0);
  CHECK(faults({}) == 1);
  CHECK(faults({{0.1, 1}}) == 1);
  CHECK(faults({{0, -1}, {0, 2}}) == 2);
  CHECK(faults({{0, 10}, {1, 7}}) == 1);  // falls by 3 G
  CHECK(faults({{0, 10}, {1, 7.1}}) == 0);
}
