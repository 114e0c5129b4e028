// SPDX-License-Identifier: Apache-2.0
#include "time/joints_start.hpp"

#include <algorithm>
#include <cmath>

#include "time/bodies.hpp"
#include "time/driven_start.hpp"

namespace brunt::time {
namespace {

/// The bodies on both sides of a joint at the start.
struct Sides {
  std::array<rigid::Pose, 2> pose;
  std::array<Vec3, 2> velocity{Vec3::Zero(), Vec3::Zero()}, spin{Vec3::Zero(), Vec3::Zero()};
  double speed = 0;
};

Sides sides_of(const model::Model& model, const model::State& state, const model::BodyJoint& joint) {
  Sides sides;
  for (std::size_t side = 0; side < 2; ++side) {
    if (joint.body[side] == no_index) continue;
    const auto b = static_cast<std::size_t>(joint.body[side]);
    sides.pose[side].centre = model.bodies[b].body.mass.centre;
    sides.velocity[side] = state.bodies[b].velocity;
    sides.spin[side] = rigid::angular_velocity(model.bodies[b].body, state.bodies[b]);
    sides.speed = std::max(sides.speed, sides.velocity[side].norm() + joint.size * sides.spin[side].norm());
  }
  return sides;
}

/// By row of a joint: is it driven?
std::array<bool, rigid::most_joint_rows> driven_rows(const model::BodyJoint& joint) {
  std::array<bool, rigid::most_joint_rows> driven{};
  std::size_t row = 0;
  for (std::size_t c = 0; c < 3; ++c)
    if (joint.joint.holds[c]) driven[row++] = joint.drive[c].has_value();
  return driven;
}

}  // namespace

std::vector<OpenedJoint> joints_opened(const model::Model& model, const model::State& state) {
  std::vector<OpenedJoint> opened;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const model::BodyJoint& joint = model.joints[j];
    const Sides sides = sides_of(model, state, joint);
    const std::array<bool, rigid::most_joint_rows> driven = driven_rows(joint);
    std::array<rigid::JointRow, rigid::most_joint_rows> rows;
    const std::size_t count = rigid::joint_rows(joint.joint, sides.pose, rows);
    double largest = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (driven[k]) continue;
      double rate = 0;
      for (std::size_t side = 0; side < 2; ++side)
        rate += rows[k].shift[side].dot(sides.velocity[side]) + rows[k].turn[side].dot(sides.spin[side]);
      largest = std::max(largest, std::abs(rate) * (rows[k].shift[0].isZero(0) ? joint.size : 1.0));
    }
    if (largest > same_speed * sides.speed) opened.push_back({j, largest, sides.speed});
  }
  return opened;
}

LocalIndex redundant_rows(const model::Model& model, const model::State& state) {
  LocalIndex redundant = 0;
  for (const rigid::JointGroup& group : model.joint_groups) {
    std::vector<rigid::Pose> pose;
    std::vector<rigid::Mat6> mobility;
    for (const LocalIndex body : group.bodies) {
      const auto b = static_cast<std::size_t>(body);
      model::BodyStep at_start;
      at_start.inertia = rigid::inertia_now(model.bodies[b].body, state.bodies[b]);
      at_start.inverse = rigid::inverse_inertia_now(model.bodies[b].body, state.bodies[b]);
      pose.push_back({model.bodies[b].body.mass.centre, Mat3::Identity()});
      mobility.push_back(mobility_of(model.bodies[b], at_start, 0));
    }
    rigid::JointSystem system;
    system.form(group, pose, mobility);
    redundant += system.redundant();
  }
  return redundant;
}

}  // namespace brunt::time
