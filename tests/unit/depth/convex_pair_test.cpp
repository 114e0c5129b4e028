// SPDX-License-Identifier: Apache-2.0
// Convex pairs against closed forms, and against sampling of directions: no direction separates sooner.
#include "depth/convex_pair.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "depth/penetration_depth.hpp"
#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;

namespace {

std::vector<Vec3> cube(double half) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back(half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return points;
}

double overlap(const std::vector<Vec3>& a, const std::vector<Vec3>& b, const Placement& p, const Vec3& u) {
  double high = -1e300, low = 1e300;
  for (const Vec3& x : a) high = std::max(high, u.dot(p(x)));
  for (const Vec3& x : b) low = std::min(low, u.dot(x));
  return high - low;
}

}  // namespace

TEST_CASE("a cube has three normals, three edges and eight corners, whatever lies inside it") {
  std::vector<Vec3> points = cube(1);
  points.emplace_back(0, 0, 1);
  points.emplace_back(0, 0, 0);
  points.emplace_back(.5, 1, 1);
  const ConvexPiece piece = convex_piece(points);
  CHECK(piece.corners.size() == 8);
  CHECK(piece.normals.size() == 3);
  CHECK(piece.edges.size() == 3);
  CHECK_THROWS_AS(convex_piece(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), std::invalid_argument);
}

TEST_CASE("depths of cubes are those of the closed forms, also when they are apart") {
  const ConvexPiece piece = convex_piece(cube(1));
  for (const double d : {1.9, 1.5, 1.0, .5, 2.5})
    CHECK(translation_depth(piece, piece, {Mat3::Identity(), {d, .13, .07}}) == Approx(2 - d).epsilon(1e-14));
  const Mat3 turned = Eigen::AngleAxisd(0.25 * 3.14159265358979324, Vec3::UnitZ()).toRotationMatrix();
  CHECK(translation_depth(piece, piece, {turned, {2.2, 0, 0}}) == Approx(1 + std::sqrt(2) - 2.2).epsilon(1e-13));
  CHECK(translation_depth(piece, piece, {Mat3::Identity(), {1.5, 0, 0}}, 1) <= 1);
}

TEST_CASE("the depth of random convex pairs is the least overlap of all directions") {
  test::Random random(1);
  for (int i = 0; i < 60; ++i) {
    std::vector<Vec3> a, b;
    for (int k = 0; k < 10; ++k) a.push_back(random.vector());
    for (int k = 0; k < 8; ++k) b.push_back(random.vector());
    const Placement p = random.placement(0.3);
    const double depth = translation_depth(convex_piece(a), convex_piece(b), p);
    double sampled = 1e300;
    Vec3 best = Vec3::UnitX();
    for (int k = 0; k < 4000; ++k) {
      const Vec3 u =
          k < 2000 ? random.direction() : (best + 0.1 * std::exp2(-k / 400.) * 32 * random.vector()).normalized();
      const double now = overlap(a, b, p, u);
      if (now < sampled) {
        sampled = now;
        best = u;
      }
    }
    CHECK(depth <= sampled + 1e-12);
    CHECK(depth > sampled - 0.1);  // samples may miss the right valley
  }
}

TEST_CASE("the narrowest overlap of a box of shifts is the least of those of its corners") {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec3> a, b;
    for (int k = 0; k < 9; ++k) a.push_back(random.vector());
    for (int k = 0; k < 7; ++k) b.push_back(random.vector());
    const ConvexPiece one = convex_piece(a), other = convex_piece(b);
    const Placement p = random.placement(0.3);
    const Mat3 shifts = 0.1 * random.rotation().toRotationMatrix() *
                        Vec3(random.uniform(), random.uniform(), random.uniform()).asDiagonal();
    double least = 1e300;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 s(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      least = std::min(least, translation_depth(one, other, {p.rotation, p.translation + shifts * s}));
    }
    const Narrowest found = narrowest_overlap(one, other, p, shifts);
    CHECK(found.depth == Approx(least).margin(1e-13));
    CHECK(found.axis.norm() == Approx(1).epsilon(1e-14));
    for (int k = 0; k < 5; ++k) {
      const Vec3 s(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      CHECK(translation_depth(one, other, {p.rotation, p.translation + shifts * s}) >= found.depth - 1e-13);
    }
  }
}

TEST_CASE("a convex body with few corners is a piece of itself, so that its bound is exact", "[law]") {
  const TriangleSurface one = test::box({-.5, -.3, -.2}, {.5, .3, .2}), slab = test::box({-5, -5, -2}, {5, 5, 0});
  const depth::Body a = depth::make_body(one), b = depth::make_body(slab);
  depth::Query query;
  query.a_in_b.rotation = Eigen::AngleAxisd(0.9, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  query.a_in_b.translation = {0, 0, .3};
  const depth::Answer answer = depth::penetration_depth(a, b, query);
  double lowest = 0;
  for (const Vec3& x : one.points) lowest = std::min(lowest, query.a_in_b(x)[2]);
  CHECK(answer.bound == Approx(-lowest).epsilon(1e-9));
  CHECK(answer.depth == Approx(-lowest).epsilon(1e-4));
  CHECK(depth::make_body(test::l_shape()).pieces.empty());
}
