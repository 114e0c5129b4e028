// SPDX-License-Identifier: Apache-2.0
#include "body_probes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace brunt::app {
namespace {

/// Axis times angle, the shorter way round.
Vec3 rotation_vector(Eigen::Quaterniond q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  return sine > 0 ? Vec3(2 * std::atan2(sine, q.w()) / sine * q.vec()) : Vec3(Vec3::Zero());
}

/// From the body's centre to that of the part alone.
Vec3 arm_of_part(const Prepared& run, std::size_t b) {
  const model::RigidBody& body = run.model.bodies[b];
  return run.state.bodies[b].orientation * (body.own.centre - body.body.mass.centre);
}

/// Inertia of the part alone about its centre, in space.
Mat3 inertia_of_part(const Prepared& run, std::size_t b) {
  const Mat3 R = run.state.bodies[b].orientation.toRotationMatrix();
  return R * run.model.bodies[b].own.inertia * R.transpose();
}

Vec3 velocity_of_part(const Prepared& run, std::size_t b) {
  const rigid::BodyState& now = run.state.bodies[b];
  return now.velocity + rigid::angular_velocity(run.model.bodies[b].body, now).cross(arm_of_part(run, b));
}

}  // namespace

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
  if (field == "velocity") return now.velocity;
  if (field == "displacement") return now.displacement;
  return body.mass.centre + now.displacement + run.model.mesh.origin;
}

Vec3 body_impulse(const Prepared& run, std::size_t b, std::string_view field) {
  const model::BodyAccount& account = run.state.body_accounts[b];
  if (field == "force") return account.impulse;
  if (field == "moment") return account.angular_impulse;
  return field == "reaction" ? account.reaction_impulse : account.reaction_angular_impulse;
}

Vec3 body_part_center(const Prepared& run, std::size_t b) {
  return body_motion(run, b, "position") + arm_of_part(run, b);
}

Vec3 body_part_momentum(const Prepared& run, std::size_t b) {
  return run.model.bodies[b].own.mass * velocity_of_part(run, b);
}

Vec3 body_part_angular_momentum(const Prepared& run, std::size_t b, const Vec3& about) {
  const Vec3 spin = rigid::angular_velocity(run.model.bodies[b].body, run.state.bodies[b]);
  return (body_part_center(run, b) - about).cross(body_part_momentum(run, b)) + inertia_of_part(run, b) * spin;
}

PartEnergy body_part_energy(const Prepared& run, std::size_t b) {
  const model::RigidBody& body = run.model.bodies[b];
  const model::BodyStep& step = run.scratch.bodies[b];
  const Vec3 arm = arm_of_part(run, b);
  const Vec3 before = step.before.velocity + step.before.spin.cross(arm);
  const Vec3 after = step.after.velocity + step.after.spin.cross(arm);
  const bool alone = body.own.mass == body.body.mass.mass;
  const Vec3 turning = alone ? step.before.angular_momentum : Vec3(inertia_of_part(run, b) * step.before.spin);
  return {0.5 * (body.own.mass * before.dot(after) + turning.dot(step.after.spin)), 0, 0, 0};
}

}  // namespace brunt::app
