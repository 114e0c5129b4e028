// SPDX-License-Identifier: Apache-2.0
// Bodies, collisions and lower bounds of simple shapes.
#include "depth/encounter.hpp"

#include <catch2/catch.hpp>

#include "depth/lower_bound.hpp"
#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;

TEST_CASE("contained bodies collide, bodies in a cavity do not") {
  const Body small = make_body(test::box({-.5, -.5, -.5}, {.5, .5, .5})),
             large = make_body(test::box({-2, -2, -2}, {2, 2, 2}));
  CHECK(Encounter{small, large, {}}.bodies_collide({}));
  CHECK(Encounter{large, small, {}}.bodies_collide({}));
  CHECK_FALSE(Encounter{small, large, {}}.bodies_collide({Mat3::Identity(), {3, 0, 0}}));
  TriangleSurface shell = test::box({-2, -2, -2}, {2, 2, 2});
  const TriangleSurface hole = test::box({-1, -1, -1}, {1, 1, 1});
  const auto first = static_cast<LocalIndex>(shell.points.size());
  shell.points.insert(shell.points.end(), hole.points.begin(), hole.points.end());
  for (const auto& t : hole.triangles) shell.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  const Body hollow = make_body(shell);
  CHECK(hollow.components.size() == 2);
  CHECK_FALSE(Encounter{small, hollow, {}}.bodies_collide({}));
  CHECK_FALSE(Encounter{hollow, small, {}}.bodies_collide({}));
  CHECK(Encounter{small, hollow, {}}.bodies_collide({Mat3::Identity(), {.6, 0, 0}}));
}

TEST_CASE("bodies without volume are refused") {
  CHECK_THROWS_AS(make_body({}), std::invalid_argument);
  TriangleSurface inside_out = test::box({0, 0, 0}, {1, 1, 1});
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK_THROWS_AS(make_body(inside_out), std::invalid_argument);
}

TEST_CASE("inner balls lie inside, the greatest first, and a box holds one of half its width") {
  const Body body = make_body(test::box({0, 0, 0}, {1, 2, 3}));
  REQUIRE_FALSE(body.balls.empty());
  CHECK(body.balls.front().depth == Approx(.5).epsilon(1e-3));
  for (std::size_t i = 0; i < body.balls.size(); ++i) {
    CHECK(body.balls[i].depth == Approx(geometry::point_depth(body.tree, body.balls[i].centre).depth).epsilon(1e-12));
    if (i > 0) CHECK(body.balls[i].depth <= body.balls[i - 1].depth);
  }
}

TEST_CASE("rounded placements are rotations, near the given ones, and the same for values that differ by rounding") {
  test::Random random(1);
  int same = 0;
  for (int i = 0; i < 200; ++i) {
    const Placement p = random.placement();
    const Placement r = rounded(p, 1.5);
    CHECK((r.rotation - p.rotation).norm() < 1e-11);
    CHECK((r.translation - p.translation).norm() < 1e-11);
    CHECK((r.rotation * r.rotation.transpose() - Mat3::Identity()).norm() < 1e-14);
    Placement near = p;
    near.rotation += 1e-16 * Mat3::Ones();
    near.translation += 1e-16 * Vec3::Ones();
    const Placement q = rounded(near, 1.5);
    same += q.rotation == r.rotation && q.translation == r.translation;
  }
  CHECK(same > 190);
}

TEST_CASE("the lower bound is exact for boxes face to face and never above a known depth") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1}));
  for (const double d : {1.9, 1.5, 1.0, .5}) {
    const Encounter encounter{cube, cube, {Mat3::Identity(), {d, .13, .07}}};
    const double bound = lower_bound(encounter, Metric::displacement).value;
    CHECK(bound <= (2 - d) * (1 + 1e-12));
    CHECK(bound > 0.99 * (2 - d));
    CHECK(lower_bound(encounter, Metric::object_norm).value <= bound);
  }
}
