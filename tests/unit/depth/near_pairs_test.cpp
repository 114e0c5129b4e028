// SPDX-License-Identifier: Apache-2.0
// Linear conditions and their second-order corrections against the motion itself.
#include "depth/near_pairs.hpp"

#include <catch2/catch.hpp>

#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;

TEST_CASE("a cube above a plate has conditions along the plate's normal") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1})),
             plate = make_body(test::box({-5, -5, -1}, {5, 5, 0}));
  const Encounter encounter{cube, plate, {Mat3::Identity(), {0, 0, 1.01}}};
  NearPairs near;
  near.find(encounter, {}, 0.1, 1e-3);
  REQUIRE_FALSE(near.conditions.empty());
  for (const NearCondition& condition : near.conditions) {
    CHECK((condition.normal - Vec3::UnitZ()).norm() < 1e-12);
    CHECK(condition.distance == Approx(.01).epsilon(1e-10));
    CHECK(condition.bound == Approx(-.009).epsilon(1e-10));
    CHECK(condition.arm[2] == Approx(-1).epsilon(1e-12));
  }
  CHECK(near.conditions.size() < near.pairs.size());  // equal points are merged
  near.find(encounter, {}, 0.005, 1e-3);
  CHECK(near.conditions.empty());
}

TEST_CASE("what satisfies the conditions with the margin is free, but for terms of second order") {
  const Body a = make_body(test::l_shape()), b = make_body(test::hub());
  test::Random random(1);
  int tested = 0;
  for (int i = 0; i < 400; ++i) {
    const Placement p = random.placement(1.2);
    Encounter encounter{a, b, p};
    if (encounter.collides({})) continue;
    constexpr double reach = 0.02;
    NearPairs near;
    near.find(encounter, {}, 2 * reach, 0);
    const Vec3 tau = 0.5 * reach * random.direction(), omega = 0.1 * reach * random.direction();
    const double second = omega.squaredNorm() * a.shape.radius;
    bool satisfied = true;
    for (const NearCondition& c : near.conditions)
      satisfied = satisfied && c.normal.dot(tau + omega.cross(c.arm)) >= c.bound + 4 * second;
    if (!satisfied) continue;
    ++tested;
    CHECK_FALSE(encounter.collides({rotation_of(omega), tau}));
  }
  CHECK(tested > 50);
}

TEST_CASE("corrections make good what a rotation misses") {
  // a plate turns above a cube: its lower face sinks by half of its thickness times 1/cos - 1
  const Body plate = make_body(test::box({-5, -5, 0}, {5, 5, 1})), cube = make_body(test::box({-1, -1, -2}, {1, 1, 0}));
  const Encounter encounter{plate, cube, {Mat3::Identity(), {0, 0, .001}}};
  NearPairs near;
  near.find(encounter, {}, 0.1, 0);
  const Vec3 omega(0.1, 0, 0), tau(0, 0, .0991);
  for (const NearCondition& c : near.conditions) CHECK(c.normal.dot(tau + omega.cross(c.arm)) >= c.bound);
  const RigidMotion motion{rotation_of(omega), tau};
  REQUIRE(encounter.bodies_collide(encounter.placement(motion)));
  CHECK(correct_bounds(encounter, motion, tau, omega, 0, near.conditions));
  double most = -1;
  for (const NearCondition& c : near.conditions)
    most = std::max(most, c.bound - c.normal.dot(tau + omega.cross(c.arm)));
  CHECK(most == Approx(.5 + std::sin(.1) - .6001 * std::cos(.1)).epsilon(1e-6));  // how deep the cube's edge is
  near.forget_corrections(0);
  for (const NearCondition& c : near.conditions) CHECK(c.bound == Approx(-.001).epsilon(1e-9));
}

TEST_CASE("triangles that touch are parted along the normal of a face, or of two edges that cross") {
  const geometry::Triangle floor{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};
  const geometry::Triangle tip{Vec3(.5, .5, 0), Vec3(.5, .6, 1), Vec3(.6, .5, 1)};
  CHECK((separating_axis(tip, floor) - Vec3::UnitZ()).norm() < 1e-15);
  CHECK((separating_axis(floor, tip) + Vec3::UnitZ()).norm() < 1e-15);
  const geometry::Triangle flat{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 3, 0)};  // face on face
  CHECK((separating_axis(flat, floor).cwiseAbs() - Vec3::UnitZ()).norm() < 1e-15);
  const geometry::Triangle ridge{Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, .1, -1)};
  const geometry::Triangle across{Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(.1, 0, 1)};
  CHECK((separating_axis(across, ridge) - Vec3::UnitZ()).norm() < 1e-15);
}
