// SPDX-License-Identifier: Apache-2.0
#include "joint_probes.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace brunt::app {
namespace {

std::array<rigid::Pose, 2> sides_of(const Prepared& run, const model::BodyJoint& joint) {
  std::array<rigid::Pose, 2> sides;
  for (std::size_t side = 0; side < 2; ++side) {
    if (joint.body[side] == no_index) continue;
    const auto b = static_cast<std::size_t>(joint.body[side]);
    const rigid::BodyState& now = run.state.bodies[b];
    sides[side] = {run.model.bodies[b].body.mass.centre + now.displacement, now.orientation.toRotationMatrix()};
  }
  return sides;
}

}  // namespace

std::size_t joint_of(const model::Model& model, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(model.joints, name, &model::BodyJoint::name) -
                                  model.joints.begin());
}

double joint_place(const Prepared& run, std::size_t joint, std::string_view field) {
  const model::BodyJoint& one = run.model.joints[joint];
  const std::array<rigid::Pose, 2> sides = sides_of(run, one);
  if (field == "angle") return rigid::joint_angle(one.joint, sides);
  const auto point = [&](std::size_t side) {
    return Vec3(sides[side].centre + sides[side].turn * one.joint.arm[side]);
  };
  return (point(0) - point(1)).norm();
}

Vec3 joint_impulse(const Prepared& run, std::size_t joint, std::string_view field) {
  const model::JointAccount& account = run.state.joint_accounts[joint];
  return field == "force" ? account.impulse : account.angular_impulse;
}

}  // namespace brunt::app
