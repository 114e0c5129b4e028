// SPDX-License-Identifier: Apache-2.0
#include "body_probes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace brunt::app {
namespace {

/// Of the last step, at its x_n.
const model::BodyStep& step_of(const Prepared& run, std::size_t b) {
  return run.scratch.bodies[b];
}

/// From the body's centre to that of the part alone.
Vec3 arm_of_part(const Prepared& run, std::size_t b, const Mat3& turn) {
  const model::RigidBody& body = run.model.bodies[b];
  return turn * (body.own.centre - body.body.mass.centre);
}

/// Inertia of the part alone about its centre, in space.
Mat3 inertia_of_part(const Prepared& run, std::size_t b) {
  const Mat3& turn = step_of(run, b).turn;
  return turn * run.model.bodies[b].own.inertia * turn.transpose();
}

/// How fast a point has moved in the last step beside the centre, as a chord; `arm`: at the start.
Vec3 shift_of_arm(const Prepared& run, std::size_t b, const Vec3& arm) {
  const model::RigidBody& body = run.model.bodies[b];
  rigid::BodyState before = run.state.bodies[b];
  const Vec3 now = before.orientation * arm, spin = rigid::angular_velocity(body.body, before);
  if (run.state.dt == 0 || arm.isZero(0)) return spin.cross(now);
  if (body.support.holds_turn)
    before.orientation = Eigen::AngleAxisd(-run.state.dt * spin.norm(), spin.normalized()) * before.orientation;
  else
    rigid::move(body.body, -run.state.dt, before);  // which it inverts
  return (now - before.orientation * arm) / run.state.dt;
}

}  // namespace

Vec3 rotation_vector(Eigen::Quaterniond q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  return sine > 0 ? Vec3(2 * std::atan2(sine, q.w()) / sine * q.vec()) : Vec3(Vec3::Zero());
}

std::optional<std::size_t> body_of_part(const model::Model& model, const std::string& part) {
  const auto found = std::ranges::find(model.bodies, part, &model::RigidBody::part);
  if (found == model.bodies.end()) return std::nullopt;
  return static_cast<std::size_t>(found - model.bodies.begin());
}

Vec3 body_motion(const Prepared& run, std::size_t b, std::string_view field) {
  const rigid::BodyState& now = run.state.bodies[b];
  const rigid::Body& body = run.model.bodies[b].body;
  if (field == "rotation") return rotation_vector(now.orientation);
  if (field == "angular_velocity") return rigid::angular_velocity(body, now);
  // of the reference point, else of the centre of mass
  const Vec3 start = run.model.bodies[b].given.reference.value_or(body.mass.centre);
  const Vec3 arm = now.orientation * (start - body.mass.centre);
  if (field == "velocity") return now.velocity + shift_of_arm(run, b, start - body.mass.centre);
  const Vec3 place = body.mass.centre + now.displacement + arm;
  if (field == "displacement") return place - start;
  return place + run.model.mesh.origin;
}

Vec3 body_impulse(const Prepared& run, std::size_t b, std::string_view field) {
  const model::BodyAccount& account = run.state.body_accounts[b];
  if (field == "force") return account.impulse;
  if (field == "moment") return account.angular_impulse;
  if (field == "reaction") return account.reaction_impulse;
  return account.reaction_angular_impulse - step_of(run, b).late_turn;
}

Vec3 body_part_center(const Prepared& run, std::size_t b) {
  return body_motion(run, b, "position") + arm_of_part(run, b, run.state.bodies[b].orientation.toRotationMatrix());
}

Vec3 body_part_momentum(const Prepared& run, std::size_t b) {
  // with the velocity (x_{n+1} - x_n)/dt of its centre, as nodes have it: the momenta of all parts add up to the
  // model's
  const rigid::BodyState& now = run.state.bodies[b];
  const Mat3& turn = step_of(run, b).turn;
  if (run.implicit)
    return run.model.bodies[b].own.mass * (now.velocity + step_of(run, b).after.spin.cross(arm_of_part(run, b, turn)));
  const Mat3 turned = now.orientation.toRotationMatrix() - turn;
  return run.model.bodies[b].own.mass * (now.velocity + arm_of_part(run, b, turned) / run.state.dt);
}

Vec3 body_part_angular_momentum(const Prepared& run, std::size_t b, const Vec3& about) {
  const model::BodyStep& step = step_of(run, b);
  const Vec3 centre = step.centre + arm_of_part(run, b, step.turn) + run.model.mesh.origin;
  return (centre - about).cross(body_part_momentum(run, b)) + inertia_of_part(run, b) * step.after.spin;
}

PartEnergy body_part_energy(const Prepared& run, std::size_t b) {
  const model::BodyStep& step = step_of(run, b);
  const Vec3 arm = arm_of_part(run, b, step.turn);
  const Vec3 before = step.before.velocity + step.before.spin.cross(arm);
  const Vec3 after = step.after.velocity + step.after.spin.cross(arm);
  const Vec3 turning = inertia_of_part(run, b) * step.before.spin;
  return {0.5 * (run.model.bodies[b].own.mass * before.dot(after) + turning.dot(step.after.spin)), 0, 0, 0};
}

}  // namespace brunt::app
