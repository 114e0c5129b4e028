// SPDX-License-Identifier: Apache-2.0
// Quantities of rigid parts: of a free body by closed form, and of a part that is less than its body by hand.
#include "app/report/body_probes.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "prepared_scene.hpp"

using namespace brunt;

namespace {

/// A box of 1 x 2 x 3 with the density 2, far from the origin: mass 12, inertia 5 about z; a cube that deforms beside
/// it sets the step.
const std::string spinning_box =
    "units: none\nmesh:\n"
    "  - {box: {part: soft, size: [1, 1, 1], elements: [1, 1, 1], at: [97, 0, 0]}}\n"
    "  - {box: {part: hard, size: [1, 2, 3], elements: [1, 1, 2], at: [100, 0, 0]}}\n"
    "materials: {m: {model: elastic, density: 1, young: 1.0e4, poisson: 0}, r: {model: rigid, density: 2}}\n"
    "parts: {soft: {material: m}, hard: {material: r}}\n"
    "initial: [{part: hard, velocity: [1, 2, 3], rotation: {axis: [0, 0, 1], point: [100.5, 1, 0], rate: 4}}]\n"
    "run: {end: 1, step: 1.0e-2}\n";

const Vec3 box_centre(100.5, 1, 1.5), box_velocity(1, 2, 3);

}  // namespace

TEST_CASE("body probes: motion, momenta and energy of a free body that turns about a principal axis") {
  support::PreparedScene scene(spinning_box);
  const app::Prepared& run = *scene.run;
  REQUIRE(run.model.mesh.origin[0] > 90);
  CHECK_FALSE(app::body_of_part(run.model, "soft"));
  REQUIRE(app::body_of_part(run.model, "hard") == std::size_t{0});
  for (int i = 0; i < 40; ++i) {
    const double t = run.state.time;
    scene.evaluate();
    const Vec3 now = box_centre + t * box_velocity;
    CHECK((app::body_motion(run, 0, "position") - now).norm() < 1e-12 * 100);
    CHECK((app::body_motion(run, 0, "displacement") - t * box_velocity).norm() < 1e-12);
    CHECK((app::body_part_center(run, 0) - now).norm() < 1e-12 * 100);
    CHECK((app::body_motion(run, 0, "rotation") - Vec3(0, 0, 4 * t)).norm() < 1e-3);  // the scheme's own angle
    CHECK((app::body_motion(run, 0, "angular_velocity") - Vec3(0, 0, 4)).norm() < 1e-12);
    scene.advance();
    CHECK((app::body_part_momentum(run, 0) - 12 * box_velocity).norm() < 1e-9);
    const Vec3 about(7, -8, 9);
    const Vec3 turning = (now - about).cross(12 * box_velocity) + Vec3(0, 0, 5 * 4);
    CHECK((app::body_part_angular_momentum(run, 0, about) - turning).norm() < 1e-12 * turning.norm());
    CHECK(app::body_part_energy(run, 0).kinetic == Approx(0.5 * 12 * 14 + 0.5 * 5 * 16).epsilon(1e-13));
  }
}

TEST_CASE("body probes: a rotation is the shorter way round, of either quaternion of an orientation") {
  const support::PreparedScene scene(spinning_box);
  const Vec3 axis = Vec3(1, -2, 2) / 3;
  constexpr double pi = std::numbers::pi;
  for (const double angle : {0.0, 1e-9, 1.0, 3.0, 4.0, 6.0, 2 * pi - 1e-9})
    for (const double sign : {1.0, -1.0}) {
      Eigen::Quaterniond& orientation = scene.run->state.bodies[0].orientation;
      orientation = Eigen::AngleAxisd(angle, axis);
      orientation.coeffs() *= sign;
      const double shorter = angle > pi ? angle - 2 * pi : angle;
      CAPTURE(angle, sign);
      CHECK((app::body_motion(*scene.run, 0, "rotation") - shorter * axis).norm() < 1e-14);
    }
}

TEST_CASE("body probes: a part whose centre is not its body's moves and turns with the body") {
  support::PreparedScene scene(spinning_box);
  app::Prepared& run = *scene.run;
  scene.evaluate();
  model::RigidBody& body = run.model.bodies[0];
  body.own.mass = 3;
  body.own.centre = body.body.mass.centre + Vec3(1, 0, 0);
  body.own.inertia = Vec3(7, 6, 5).asDiagonal();
  const Mat3 quarter = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ()).matrix();
  model::BodyStep& step = run.scratch.bodies[0];
  step.turn = quarter;  // the arm is along y at t_n, along -x at t_{n+1}
  run.state.bodies[0].orientation = quarter * quarter;
  run.state.dt = 0.5;
  CHECK((app::body_part_center(run, 0) - (app::body_motion(run, 0, "position") - Vec3(1, 0, 0))).norm() < 1e-12);
  const Vec3 momentum = 3 * (run.state.bodies[0].velocity + Vec3(-2, -2, 0));
  CHECK((app::body_part_momentum(run, 0) - momentum).norm() < 1e-12);
  step.before.velocity = Vec3(1, 0, 0);
  step.before.spin = Vec3(0, 1, 2);
  step.after.velocity = Vec3(0, 1, 0);
  step.after.spin = Vec3(0, 3, 4);
  // at the arm (0, 1, 0): (1 - 2, 0, 0) and (-4, 1, 0), with the product 4; the moments about y and z are 7 and 5
  CHECK(app::body_part_energy(run, 0).kinetic == Approx(0.5 * (3 * 4 + 7 * 1 * 3 + 5 * 2 * 4)));
  const Vec3 from = step.centre + run.model.mesh.origin;
  CHECK((app::body_part_angular_momentum(run, 0, from) - (Vec3(0, 1, 0).cross(momentum) + Vec3(0, 21, 20))).norm() <
        1e-12);
}

TEST_CASE("body probes: impulses, without what supports give to the turning body after the half step") {
  support::PreparedScene scene(spinning_box);
  scene.evaluate();
  model::BodyAccount& account = scene.run->state.body_accounts[0];
  account.impulse = {1, 2, 3};
  account.angular_impulse = {4, 5, 6};
  account.reaction_impulse = {7, 8, 9};
  account.reaction_angular_impulse = {10, 11, 12};
  scene.run->scratch.bodies[0].late_turn = {1, 1, 2};
  CHECK(app::body_impulse(*scene.run, 0, "force") == Vec3(1, 2, 3));
  CHECK(app::body_impulse(*scene.run, 0, "moment") == Vec3(4, 5, 6));
  CHECK(app::body_impulse(*scene.run, 0, "reaction") == Vec3(7, 8, 9));
  CHECK(app::body_impulse(*scene.run, 0, "reaction_moment") == Vec3(9, 10, 10));
}
