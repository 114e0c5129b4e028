// SPDX-License-Identifier: Apache-2.0
// The exact accumulator against 128-bit integers and against sums whose rounding is known by hand.
#include "comm/exact_sum.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

using brunt::comm::ExactAccumulator;

namespace {

double sum(std::initializer_list<double> values) {
  ExactAccumulator accumulator;
  for (const double value : values) accumulator.add(value);
  return accumulator.round();
}

double power(int exponent) {
  return std::ldexp(1.0, exponent);
}

__extension__ using Integer128 = __int128;

constexpr double greatest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("an exact sum rounds to nearest, ties to even") {
  CHECK(sum({}) == 0.0);
  CHECK(sum({1.0, power(-53)}) == 1.0);
  CHECK(sum({1.0, power(-53), least}) == 1.0 + power(-52));
  CHECK(sum({1.0, power(-53), -least}) == 1.0);
  CHECK(sum({1.0, power(-52), power(-53)}) == 1.0 + power(-51));
  CHECK(sum({-1.0, -power(-53), -least}) == -1.0 - power(-52));
  CHECK(sum({-1.0, -power(-52), -power(-53)}) == -1.0 - power(-51));
  CHECK(sum({power(53), 1.0, power(-1000)}) == power(53) + 2.0);
}

TEST_CASE("nothing is lost to cancellation") {
  CHECK(sum({1.0e100, 1.0, -1.0e100}) == 1.0);
  CHECK(sum({greatest, 3.0 * least, -greatest}) == 3.0 * least);
  CHECK(sum({power(1000), -power(947), -power(1000), power(947), -least}) == -least);
  CHECK(sum({0.1, 0.2, 0.3, -0.1, -0.2, -0.3}) == 0.0);
  CHECK(sum({power(64), -least}) == power(64));
}

TEST_CASE("subnormal numbers add exactly and grow into normal ones") {
  const double smallest_normal = std::numeric_limits<double>::min();
  CHECK(sum({least, least, least}) == 3.0 * least);
  CHECK(sum({smallest_normal, -least}) == smallest_normal - least);
  CHECK(sum({smallest_normal - least, least}) == smallest_normal);
  CHECK(sum({-least}) == -least);
}

TEST_CASE("the range of double may be left and entered again") {
  CHECK(sum({greatest, greatest, -greatest}) == greatest);
  CHECK(sum({greatest, greatest}) == infinity);
  CHECK(sum({-greatest, -greatest}) == -infinity);
  CHECK(sum({greatest, power(969)}) == greatest);  // a quarter of the last place
  CHECK(sum({greatest, power(970)}) == infinity);  // half of it: the tie goes to 2^1024
  CHECK(std::isnan(sum({1.0, infinity})));
  CHECK(std::isnan(sum({infinity, -infinity})));
  CHECK(std::isnan(sum({std::numeric_limits<double>::quiet_NaN()})));
}

TEST_CASE("random sums agree with 128-bit integers") {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> digits(-(std::int64_t{1} << 53), std::int64_t{1} << 53);
  std::uniform_int_distribution<int> exponent(0, 60);
  for (const int scale : {0, -1074, -50, 900}) {
    for (int trial = 0; trial < 500; ++trial) {
      Integer128 exact = 0;
      ExactAccumulator accumulator;
      const int terms = 1 + trial % 40;
      for (int i = 0; i < terms; ++i) {
        const std::int64_t m = digits(random);
        const int e = exponent(random);
        exact += static_cast<Integer128>(m) * (static_cast<Integer128>(1) << e);
        accumulator.add(std::ldexp(static_cast<double>(m), e + scale));
      }
      REQUIRE(accumulator.round() == std::ldexp(static_cast<double>(exact), scale));
    }
  }
}

TEST_CASE("order, grouping and carries do not matter") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-1070, 1000);
  std::vector<double> values(3000);
  for (double& value : values) value = std::ldexp(mantissa(random), exponent(random));
  ExactAccumulator forward;
  for (const double value : values) forward.add(value);

  std::ranges::shuffle(values, random);
  ExactAccumulator first, second;
  for (std::size_t i = 0; i < values.size(); ++i) (i % 3 == 0 ? first : second).add(values[i]);
  (void)second.raw();  // carried in between
  first.add(second);
  CHECK(first.round() == forward.round());

  for (const double value : values) first.add(-value);
  CHECK(first.round() == 0.0);
  first.add(2.5);
  first.clear();
  CHECK(first.round() == 0.0);
}

TEST_CASE("an accumulator added to itself again and again does not overflow") {
  ExactAccumulator accumulator;
  accumulator.add(-1.0);
  for (int i = 0; i < 100; ++i) accumulator.add(ExactAccumulator(accumulator));
  CHECK(accumulator.round() == -power(100));
}
