// SPDX-License-Identifier: Apache-2.0
// Signs of determinants against 128-bit integers, for coordinates whose differences no double holds.
#include "geometry/triangles/exact_sign.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "integer_triangles.hpp"

using namespace brunt;
using namespace brunt::geometry;
using namespace brunt::geometry::testing;

namespace {

using Random = std::mt19937_64;

std::int64_t whole(Random& random, std::int64_t reach) {
  return std::uniform_int_distribution<std::int64_t>(-reach, reach)(random);
}

/// x is small or a multiple of 2^10 up to 2^58: the difference of two needs up to 58 bits.
std::array<std::int64_t, 3> mixed_point(Random& random) {
  const std::int64_t x = random() % 2 == 0 ? whole(random, 1000) : 1024 * whole(random, std::int64_t{1} << 48);
  return {x, whole(random, 1 << 28), whole(random, 1 << 28)};
}

Vec3 as_doubles(const std::array<std::int64_t, 3>& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

IntVec as_integers(const std::array<std::int64_t, 3>& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

TEST_CASE("signs of volumes and areas are exact where differences of coordinates are not doubles") {
  Random random(31);
  int wrong = 0, flat = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto a = mixed_point(random), b = mixed_point(random), c = mixed_point(random);
    auto d = mixed_point(random);
    if (k % 2 == 0) {  // nearly in the plane of the others, or in it: a parallelogram's corner, moved by one or not
      for (std::size_t i = 0; i < 3; ++i) d[i] = b[i] + c[i] - a[i];
      const std::size_t moved = random() % 3;
      if (moved > 0) d[moved] += whole(random, 1);
    }
    if (static_cast<std::int64_t>(as_doubles(d)[0]) != d[0]) continue;  // not a double
    const IntVec u = as_integers(b) - as_integers(a), v = as_integers(c) - as_integers(a);
    const IntVec w = as_integers(d) - as_integers(a), n = testing::cross(u, v);
    const int expected = sign(testing::dot(n, w));
    flat += static_cast<int>(expected == 0);
    wrong += static_cast<int>(orientation(as_doubles(a), as_doubles(b), as_doubles(c), as_doubles(d)) != expected);
    for (int axis = 0; axis < 3; ++axis)
      wrong += static_cast<int>(turn(as_doubles(a), as_doubles(b), as_doubles(c), axis) !=
                                sign(n[static_cast<std::size_t>(axis)]));
  }
  CHECK(wrong == 0);
  CHECK(flat > 1000);
}

TEST_CASE("four points of one line or plane have no sign, at any scale") {
  for (const double scale : {1e-80, 1e-20, 0.1, 1.0, 3e15, 1e80}) {
    const auto at = [&](double x, double y, double z) { return Vec3(scale * Vec3(x, y, z)); };
    CHECK(orientation(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(8, 5, 0)) == 0);
    CHECK(orientation(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(8, 5, 1e-15)) == 1);
    CHECK(orientation(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(8, 5, -1e-15)) == -1);
    CHECK(without_area({at(0, 0, 0), at(1, 2, 4), at(2, 4, 8)}));
    CHECK_FALSE(without_area({at(0, 0, 0), at(1, 2, 4), at(2, 4, 8 + 1e-14)}));
  }
}
