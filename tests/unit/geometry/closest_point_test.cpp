// SPDX-License-Identifier: Apache-2.0
// Closest points against exact values on rectangles and against a dense search on warped faces.
#include "geometry/closest_point.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

using brunt::Vec3;
using namespace brunt::geometry;

namespace {

const std::array<Vec3, 4> rectangle{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)};

/// Distance by brute force: a fine grid over the face, so never below the true one.
double dense_distance(const Vec3& x, Corners corners, int cells) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const auto w = face_weights(4, 2.0 * i / cells - 1, 2.0 * j / cells - 1);
      Vec3 y = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k) y += w[k] * corners[k];
      best = std::min(best, (x - y).norm());
    }
  }
  return best;
}

}  // namespace

TEST_CASE("closest point on a rectangle is exact and names its region") {
  const auto inside = closest_point({0.5, 0.75, 0.3}, rectangle);
  REQUIRE(inside);
  CHECK(inside->region == Region::face);
  CHECK(inside->xi == Approx(-0.5).epsilon(1e-14));
  CHECK(inside->eta == Approx(0.5).epsilon(1e-14));
  CHECK((inside->point - Vec3(0.5, 0.75, 0)).norm() < 1e-15);

  const auto edge = closest_point({2.5, 0.25, -0.1}, rectangle);
  REQUIRE(edge);
  CHECK(edge->region == Region::edge1);
  CHECK((edge->point - Vec3(2, 0.25, 0)).norm() < 1e-15);

  const auto vertex = closest_point({-1, 2, 1}, rectangle);
  REQUIRE(vertex);
  CHECK(vertex->region == Region::vertex3);
  CHECK(vertex->point == rectangle[3]);
  CHECK(vertex->weights[3] == 1.0);
}

TEST_CASE("a projection within the tolerance of an edge counts as on the face") {
  CHECK(closest_point({2 * (1 + 0.5 * face_tolerance), 0.5, 1}, rectangle)->region == Region::face);
  CHECK(closest_point({2 * (1 + 4 * face_tolerance), 0.5, 1}, rectangle)->region == Region::edge1);
}

TEST_CASE("closest point on a triangle is exact") {
  const std::array<Vec3, 3> triangle{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)};
  const auto inside = closest_point({0.25, 0.5, 3}, triangle);
  REQUIRE(inside);
  CHECK(inside->region == Region::face);
  CHECK((inside->point - Vec3(0.25, 0.5, 1)).norm() < 1e-15);
  CHECK(inside->weights[3] == 0.0);
  const auto edge = closest_point({1, 1, 0}, triangle);
  REQUIRE(edge);
  CHECK(edge->region == Region::edge1);
  CHECK((edge->point - Vec3(0.5, 0.5, 1)).norm() < 1e-15);
  CHECK(closest_point({-1, -2, 1}, triangle)->region == Region::vertex0);
}

TEST_CASE("closest point on random warped quadrilaterals is never farther than a dense search") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.25, 0.25), height(-0.6, 0.6), place(-1.6, 1.6);
  for (int trial = 0; trial < 300; ++trial) {
    std::array<Vec3, 4> quad{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
    for (Vec3& corner : quad) corner += Vec3(shift(random), shift(random), shift(random));
    const Vec3 x(place(random), place(random), height(random));
    const auto found = closest_point(x, quad);
    REQUIRE(found);
    const double weight_sum = found->weights[0] + found->weights[1] + found->weights[2] + found->weights[3];
    CHECK(weight_sum == Approx(1).epsilon(1e-14));
    CHECK((x - found->point).norm() <= dense_distance(x, quad, 60) + 1e-5);
    if (found->region == Region::face && std::max(std::abs(found->xi), std::abs(found->eta)) < 1) {
      const Vec3 offset = x - found->point, normal = face_normal(quad, found->xi, found->eta);
      CHECK((offset - offset.dot(normal) * normal).norm() < 1e-9);
    }
  }
}

// Squared distances far from the face resolve its rim to half the digits only: by rounding a sample of the rim may be
// nearer than the nearest point of the edge.
TEST_CASE("a point far beside a warped quadrilateral is nearest to its rim, never to the face") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2), place(-1, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    std::array<Vec3, 4> corners = rectangle;
    for (Vec3& corner : corners) corner += Vec3(jitter(random), jitter(random), 2 * jitter(random));
    const Vec3 x(1 + 8 * place(random), 0.5 + 8 * place(random), place(random));
    const auto closest = closest_point(x, corners);
    REQUIRE(closest);
    if (closest->region != Region::face) continue;
    const Vec3 offset = x - closest->point, normal = face_normal(corners, closest->xi, closest->eta);
    CAPTURE(trial, closest->xi, closest->eta);
    CHECK((offset - offset.dot(normal) * normal).norm() < 1e-5);
  }
}

TEST_CASE("hard faces end in an answer or a refusal, never NaN") {
  SECTION("warped by 45 degrees") {
    const std::array<Vec3, 4> quad{Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(1, 1, 0), Vec3(0, 1, 1)};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 2);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec3 x(place(random), place(random), place(random));
      const auto found = closest_point(x, quad);
      REQUIRE(found);
      REQUIRE(found->point.allFinite());
    }
  }
  SECTION("a quadrilateral with two coinciding corners is a triangle") {
    const std::array<Vec3, 4> quad{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 1, 0)};
    const auto found = closest_point({0.2, 0.3, 0.5}, quad);
    REQUIRE(found);
    CHECK((found->point - Vec3(0.2, 0.3, 0)).norm() < 1e-9);
    CHECK(face_normal(quad, -1, 1).dot(Vec3::UnitZ()) == Approx(1));
  }
  SECTION("a needle 1 : 10^4") {
    const std::array<Vec3, 4> quad{Vec3(0, 0, 0), Vec3(1e4, 0, 0), Vec3(1e4, 1, 0), Vec3(0, 1, 0)};
    const auto found = closest_point({5000, 0.5, 2}, quad);
    REQUIRE(found);
    CHECK((found->point - Vec3(5000, 0.5, 0)).norm() < 1e-9);
  }
  SECTION("no area: refused") {
    const std::array<Vec3, 4> line{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
    const std::array<Vec3, 3> point{Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)};
    CHECK_FALSE(closest_point({0, 0, 1}, line));
    CHECK_FALSE(closest_point({0, 0, 1}, point));
  }
  SECTION("not finite: refused") {
    CHECK_FALSE(closest_point({std::numeric_limits<double>::quiet_NaN(), 0, 1}, rectangle));
  }
}

TEST_CASE("area vector and normal of a face seen from outside") {
  CHECK((area_vector(rectangle) - Vec3(0, 0, 2)).norm() < 1e-15);
  CHECK((face_normal(rectangle, 0.3, -0.2) - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(longest_edge(rectangle) == 2.0);
}

TEST_CASE("the width of a face is its height over its longest edge") {
  CHECK(width(rectangle) == Approx(1).epsilon(1e-15));
  const std::array<Vec3, 3> triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 0.5, 0)};
  CHECK(width(triangle) == Approx(0.5).epsilon(1e-15));
  const std::array<Vec3, 4> slanted{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(4, 0.25, 0), Vec3(1, 0.25, 0)};
  CHECK(width(slanted) == Approx(0.25).epsilon(1e-15));
  const std::array<Vec3, 3> point{Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)};
  CHECK(width(point) == 0);
}
