// SPDX-License-Identifier: Apache-2.0
// Eight closest points at a time against closest_point, which has tests of its own.
#include "geometry/closest_place.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <random>

#include "geometry/closest_point.hpp"

using namespace brunt;

namespace {

struct Shot {
  std::array<Vec3, 4> corners;
  Vec3 x;
};

/// A parallelogram, warped by up to `warp` of its edges, with points around it.
Shot random_shot(std::mt19937& random, double warp) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  const Vec3 at = vector(), a = Vec3(2, 0, 0) + 0.3 * vector(), b = Vec3(0, 1.5, 0) + 0.3 * vector();
  Shot shot{{at, at + a, at + a + b, at + b}, {}};
  for (Vec3& corner : shot.corners) corner += warp * vector();
  shot.x = at + (0.5 + 0.9 * unit(random)) * a + (0.5 + 0.9 * unit(random)) * b + 0.4 * vector();
  return shot;
}

void set(geometry::PackVec& to, int lane, const Vec3& from) {
  to.x[lane] = from[0];
  to.y[lane] = from[1];
  to.z[lane] = from[2];
}

geometry::PackPlace places(const std::array<Shot, pack_width>& shots) {
  geometry::PackVec x{};
  geometry::PackQuad quad{};
  for (int lane = 0; lane < pack_width; ++lane) {
    const Shot& shot = shots[static_cast<std::size_t>(lane)];
    set(x, lane, shot.x);
    for (int i = 0; i < 4; ++i) set(quad.corner[i], lane, shot.corners[static_cast<std::size_t>(i)]);
  }
  return closest_place(x, quad);
}

bool is_face(geometry::Region region) {
  return region == geometry::Region::face;
}

}  // namespace

TEST_CASE("eight at a time: the places of closest_point, and hardly any that are left to it") {
  std::mt19937 random(7);
  int known = 0, on_face = 0, total = 0;
  for (const double warp : {0.0, 0.02, 0.1})
    for (int k = 0; k < 2000; ++k) {
      std::array<Shot, pack_width> shots;
      for (Shot& shot : shots) shot = random_shot(random, warp);
      const geometry::PackPlace place = places(shots);
      for (int lane = 0; lane < pack_width; ++lane) {
        ++total;
        if (place.known[lane] == 0) continue;
        ++known;
        const Shot& shot = shots[static_cast<std::size_t>(lane)];
        const auto expected = geometry::closest_point(shot.x, shot.corners);
        REQUIRE(expected);
        REQUIRE(is_face(expected->region) == (place.on_face[lane] != 0));
        REQUIRE(std::abs(expected->xi - place.xi[lane]) < 1e-12);
        REQUIRE(std::abs(expected->eta - place.eta[lane]) < 1e-12);
        if (place.on_face[lane] != 0) ++on_face;
      }
    }
  CHECK(known > 0.99 * total);
  CHECK(on_face > 0.2 * total);
  CHECK(on_face < 0.8 * total);  // both ways were taken
}

TEST_CASE("a pack at a time: what a lane gives has the same bits whatever the others hold") {
  std::mt19937 random(8);
  constexpr int last = pack_width - 1;
  for (int k = 0; k < 500; ++k) {
    std::array<Shot, pack_width> shots;
    for (Shot& shot : shots) shot = random_shot(random, 0.1);
    std::array<Shot, pack_width> others;
    for (Shot& shot : others) shot = random_shot(random, k % 2 == 0 ? 0.0 : 0.5);  // settle sooner, or later
    others[last] = shots[2];
    const geometry::PackPlace one = places(shots), other = places(others);
    REQUIRE(one.known[2] == other.known[last]);
    if (one.known[2] == 0) continue;
    const double a[4]{one.xi[2], one.eta[2], one.edge[2], one.along[2]};
    const double b[4]{other.xi[last], other.eta[last], other.edge[last], other.along[last]};
    REQUIRE(one.on_face[2] == other.on_face[last]);
    REQUIRE(std::memcmp(a, b, one.on_face[2] != 0 ? 2 * sizeof(double) : sizeof a) == 0);
  }
}

TEST_CASE("a pack at a time: faces without area and points that are not finite are left to closest_point") {
  std::mt19937 random(9);
  const auto spoil = [](Shot& shot, int how) {
    if (how == 0) shot.x[0] = std::numeric_limits<double>::quiet_NaN();
    if (how == 1) shot.x[1] = std::numeric_limits<double>::infinity();
    if (how == 2) shot.corners[2][2] = std::numeric_limits<double>::quiet_NaN();
    if (how == 3) shot.corners = {shot.x, shot.x, shot.x, shot.x};
  };
  for (int how = 0; how < 4; ++how) {
    std::array<Shot, pack_width> shots;
    for (Shot& shot : shots) shot = random_shot(random, 0);
    const int spoilt = how % pack_width;
    spoil(shots[static_cast<std::size_t>(spoilt)], how);
    const geometry::PackPlace place = places(shots);
    CAPTURE(how);
    for (int lane = 0; lane < pack_width; ++lane) CHECK((place.known[lane] == 0) == (lane == spoilt));
  }
}
