// SPDX-License-Identifier: Apache-2.0
// Starts, local steps and walks.
#include "depth/walk.hpp"

#include <catch2/catch.hpp>

#include "depth/starts.hpp"
#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;

namespace {

constexpr Metric metrics[] = {Metric::translation, Metric::displacement, Metric::object_norm};

}  // namespace

TEST_CASE("a step without conditions goes back by the trust region, one with them stays above its bounds") {
  const Body a = make_body(test::l_shape());
  test::Random random(1);
  LocalSolver solver;
  for (int i = 0; i < 200; ++i) {
    const RigidMotion motion{rotation_of(random.uniform(0, 2) * random.direction()), random.vector()};
    std::vector<NearCondition> conditions;
    for (int k = 0; k < i % 7; ++k) {
      NearCondition c;
      c.normal = random.direction();
      c.arm = random.vector();
      c.bound = -0.01 * random.uniform();
      conditions.push_back(c);
    }
    for (const Metric metric : metrics) {
      LocalProblem problem;
      problem.metric = metric;
      problem.trust = 0.05;
      const LocalStep step = solver.solve(a.shape, motion, conditions, problem);
      REQUIRE(step.solved);
      const double before = length_of(a.shape, metric, motion);
      CHECK(step.predicted <= before * (1 + 1e-9));
      CHECK(step.size <= 0.05 * (1 + 1e-9));
      for (const NearCondition& c : conditions)
        CHECK(c.normal.dot(step.tau + step.omega.cross(c.arm)) >= c.bound - 1e-10);
      // the model is right to second order
      CHECK(std::abs(length_of(a.shape, metric, step.motion) - step.predicted) < 0.05);
      if (conditions.empty()) CHECK(step.predicted < before - 0.04);
    }
  }
}

TEST_CASE("starts are free, sorted, and turn with the bodies") {
  const Body a = make_body(test::l_shape()), b = make_body(test::hub());
  std::mt19937 engine(3);
  Encounter encounter{a, b, {test::uniform_rotation(engine), {.5, .2, .3}}};
  REQUIRE(encounter.collides({}));
  StartOptions options;
  const std::vector<Start> starts = find_starts(encounter, options);
  REQUIRE(starts.size() > 10);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    CHECK_FALSE(encounter.collides(starts[i].motion));
    CHECK(starts[i].length == Approx(length_of(a.shape, options.metric, starts[i].motion)).epsilon(1e-14));
    if (i > 0) CHECK(starts[i].length >= starts[i - 1].length);
  }
  // the file of B turned
  test::Random random(2);
  const Placement frame = random.placement();
  TriangleSurface moved_b = test::hub();
  for (Vec3& x : moved_b.points) x = frame(x);
  const Body b2 = make_body(moved_b);
  Encounter other{a, b2, {frame.rotation * encounter.start.rotation, frame(encounter.start.translation)}};
  const std::vector<Start> again = find_starts(other, options);
  REQUIRE(again.size() == starts.size());
  CHECK(again.front().length == Approx(starts.front().length).epsilon(1e-6));
}

TEST_CASE("walks end free, no longer than they began, and touch after the pull") {
  const Body a = make_body(test::pawn()), b = make_body(test::hub());
  Encounter encounter{a, b, {Mat3::Identity(), {.9, .2, -.4}}};
  REQUIRE(encounter.collides({}));
  Walker walker;
  for (const Metric metric : metrics) {
    StartOptions options;
    options.metric = metric;
    WalkOptions walking;
    walking.metric = metric;
    int walked = 0;
    for (const Start& start : find_starts(encounter, options)) {
      if (++walked > 5) break;
      Walk walk = Walker::begin(encounter, start.motion, walking);
      walker.advance(encounter, walk, walking, 60);
      CHECK(walk.length <= start.length);
      CHECK_FALSE(encounter.collides(walk.motion));
      const RigidMotion end = pulled(encounter, metric, walk.motion, 1e-9);
      CHECK_FALSE(encounter.collides(end));
      CHECK(encounter.collides(along_screw(end, 1 - 1e-7)));
      CHECK(length_of(a.shape, metric, end) <= walk.length * (1 + 1e-14));
    }
  }
}
