// SPDX-License-Identifier: Apache-2.0
#include "time/joints.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "time/bodies.hpp"
#include "time/driven_start.hpp"

namespace brunt::time {
namespace {

using model::BodyJoint;
using model::BodyStep;
using model::JointStep;
using rigid::JointGroup;
using rigid::JointPlace;
using rigid::Pose;

Pose pose_of(const model::RigidBody& body, const rigid::BodyState& state) {
  return {body.body.mass.centre + state.displacement, state.orientation.toRotationMatrix()};
}

/// Calls visit(place in the group, body of the model).
template <class Visit>
void for_bodies(const JointGroup& group, Visit&& visit) {
  for (std::size_t k = 0; k < group.bodies.size(); ++k) visit(k, static_cast<std::size_t>(group.bodies[k]));
}

/// The six numbers of a body of the group.
auto part(auto& of_group, std::size_t k) {
  return of_group.template segment<6>(static_cast<Eigen::Index>(6 * k));
}

/// Of the bodies of a group at x_n.
std::vector<Pose> poses(const model::Scratch& scratch, const JointGroup& group) {
  std::vector<Pose> all;
  for_bodies(group, [&](std::size_t, std::size_t b) {
    all.push_back({scratch.bodies[b].centre, scratch.bodies[b].turn});
  });
  return all;
}

/// Where the present velocities lead to.
std::vector<Pose> poses_after(const model::Model& model, const model::State& state, const model::Scratch& scratch,
                              const JointGroup& group, double dt) {
  std::vector<Pose> all;
  for_bodies(group, [&](std::size_t, std::size_t b) {
    rigid::BodyState moving = state.bodies[b];
    advance_body(model.bodies[b], scratch.bodies[b], dt, moving);
    all.push_back(pose_of(model.bodies[b], moving));
  });
  return all;
}

/// Velocities of the centres and spins.
Eigen::VectorXd velocities(const model::Scratch& scratch, const JointGroup& group,
                           model::BodyMomentum BodyStep::*when) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * group.bodies.size()));
  for_bodies(group, [&](std::size_t k, std::size_t b) {
    const model::BodyMomentum& one = scratch.bodies[b].*when;
    part(all, k) << one.velocity, one.spin;
  });
  return all;
}

/// Gives the bodies of a group these impulses; W lets `change` through.
void push_group(const model::Model& model, const JointGroup& group, const Eigen::VectorXd& impulse,
                const Eigen::VectorXd& change, double drag, model::Scratch& scratch) {
  for_bodies(group, [&](std::size_t k, std::size_t b) {
    push_body(model.bodies[b], part(impulse, k), part(change, k), drag, scratch.bodies[b]);
  });
}

/// The joints change the rates of their rows.
void change_rates(const model::Model& model, const JointGroup& group, const Eigen::VectorXd& change, double drag,
                  JointStep& now, model::Scratch& scratch) {
  const Eigen::VectorXd impulses = now.system.impulses(change), on_bodies = now.system.on_bodies(impulses);
  now.impulses += impulses;
  push_group(model, group, on_bodies, now.system.moved(on_bodies), drag, scratch);
}

/// Calls visit(row, drive) for the driven rows of a support.
template <class Visit>
void for_driven(const model::Model& model, const BodyJoint& joint, const JointPlace& place, Visit&& visit) {
  Eigen::Index row = place.first_row;
  for (std::size_t c = 0; c < 3; ++c) {
    if (joint.drive[c]) visit(row, nth(model.supports.drives, *joint.drive[c]));
    if (joint.joint.holds[c]) ++row;
  }
}

/// The gaps at x_{n+1}: none, but where a drive moves the point. gaps: at x_n.
void want_gaps(const model::Model& model, const model::State& state, const model::Scratch& scratch,
               const JointGroup& group, const Eigen::VectorXd& gaps, const Interval& step, JointStep& now) {
  now.wanted.setZero(group.rows);
  const Eigen::VectorXd before = now.system.rates(velocities(scratch, group, &BodyStep::before));
  for (const JointPlace& place : group.joints)
    for_driven(model, nth(model.joints, place.number), place, [&](Eigen::Index row, const model::Drive& drive) {
      now.wanted[row] = gaps[row] + step.dt * driven_component(drive, before[row], state.time, step.dt, step.dt_mean);
    });
}

/// Which joint's row is the widest open, over the size of its bodies.
struct Widest {
  std::size_t joint = 0;
  double gap = 0;
};
Widest widest_gap(const model::Model& model, const JointGroup& group, const Eigen::VectorXd& open) {
  Widest widest;
  for (const JointPlace& place : group.joints) {
    const auto j = static_cast<std::size_t>(place.number);
    for (std::size_t k = 0; k < rigid::rows_of(model.joints[j].joint); ++k) {
      const double size = k < 3 ? model.joints[j].size : 1.0;
      const double gap = std::abs(open[place.first_row + static_cast<Eigen::Index>(k)]) / size;
      if (!(gap <= widest.gap)) widest = {j, std::isnan(gap) ? std::numeric_limits<double>::infinity() : gap};
    }
  }
  return widest;
}

/// Newton's method with the matrix of x_n, until rounding is reached: the gaps of an iterate are a share
/// (turn of a step)^2 of those before.
void close(const model::Model& model, const model::State& state, const JointGroup& group, const Interval& step,
           JointStep& now, model::Scratch& scratch) {
  constexpr int most = 50;
  constexpr double gains = 0.5;    // less than that: rounding
  constexpr double closed = 1e-9;  // of the size of the bodies
  double last = std::numeric_limits<double>::infinity();
  Widest widest;
  for (int i = 0; i < most; ++i) {
    const Eigen::VectorXd open =
        rigid::JointSystem::gaps(group, poses_after(model, state, scratch, group, step.dt)) - now.wanted;
    widest = widest_gap(model, group, open);
    if (!(widest.gap > 0) || !(widest.gap < gains * last)) break;
    last = widest.gap;
    change_rates(model, group, -open / step.dt, step.drag, now, scratch);
  }
  if (widest.gap <= closed) return;
  const std::string& name = model.joints[widest.joint].name;
  throw GuardError(fmt::format(
      "joint '{}' stays open by {:.2g} of the size of its bodies in the step from t = {:g}: likely cause: joints that "
      "contradict each other or a drive (several hinges on one line need the same axis and points to all digits: use "
      "one), a dead centre, masses that differ by more than 1e8, or bodies that turn by more than half a radian in a "
      "step",
      name.empty() ? "support at a reference point" : name, widest.gap, state.time));
}

/// What a joint gives to its first body, about that body's centre.
model::Wrench impulse_on_first(const JointPlace& place, const std::array<Pose, 2>& sides,
                               const Eigen::VectorXd& impulses) {
  std::array<rigid::JointRow, rigid::most_joint_rows> rows;
  const std::size_t count = rigid::joint_rows(place.joint, sides, rows);
  model::Wrench given;
  for (std::size_t k = 0; k < count; ++k) {
    const double impulse = impulses[place.first_row + static_cast<Eigen::Index>(k)];
    given.force += impulse * rows[k].shift[0];
    given.moment += impulse * rows[k].turn[0];
  }
  return given;
}

}  // namespace

void place_joints(model::Model& model, model::State& state, model::Scratch& scratch) {
  std::vector<rigid::Joint> joints;
  std::vector<std::array<LocalIndex, 2>> bodies;
  for (BodyJoint& joint : model.joints) {
    joint.joint.arm = {joint.point, joint.point};
    joint.size = 0;
    for (std::size_t side = 0; side < 2; ++side) {
      if (joint.body[side] == no_index) continue;
      model::RigidBody& body = nth(model.bodies, joint.body[side]);
      const rigid::MassProperties& mass = body.body.mass;
      body.is_jointed = true;
      joint.joint.arm[side] -= mass.centre;
      joint.size =
          std::max(joint.size, joint.joint.arm[side].norm() + std::sqrt(mass.inertia.trace() / (2 * mass.mass)));
    }
    joints.push_back(joint.joint);
    bodies.push_back(joint.body);
  }
  model.joint_groups = rigid::group_bodies(joints, bodies, static_cast<LocalIndex>(model.bodies.size()));
  state.joint_accounts.assign(model.joints.size(), {});
  scratch.joints.assign(model.joint_groups.size(), {});
}

void hold_joints(const model::Model& model, const model::State& state, const Interval& step, model::Scratch& scratch) {
  for (std::size_t g = 0; g < model.joint_groups.size(); ++g) {
    const JointGroup& group = model.joint_groups[g];
    JointStep& now = scratch.joints[g];
    std::vector<rigid::Mat6> mobility;
    for_bodies(group, [&](std::size_t, std::size_t b) {
      mobility.push_back(mobility_of(model.bodies[b], scratch.bodies[b], step.drag));
    });
    const std::vector<Pose> pose = poses(scratch, group);
    now.system.form(group, pose, mobility);
    now.impulses.setZero(group.rows);
    want_gaps(model, state, scratch, group, rigid::JointSystem::gaps(group, pose), step, now);
    close(model, state, group, step, now, scratch);
    for_bodies(group, [&](std::size_t, std::size_t b) { scratch.bodies[b].predicted = scratch.bodies[b].after; });
  }
}

void couple_carriers(const model::Model& model, const model::Scratch& scratch, std::vector<contact::Carrier>& carriers,
                     std::vector<contact::CoupledBodies>& coupled) {
  coupled.resize(model.joint_groups.size());
  for (std::size_t g = 0; g < coupled.size(); ++g) {
    contact::CoupledBodies& group = coupled[g];
    group.bodies = model.joint_groups[g].bodies;
    group.mobility = scratch.joints[g].system.coupled_mobility();
    group.alone.clear();
    for_bodies(model.joint_groups[g], [&](std::size_t k, std::size_t b) {
      const auto at = static_cast<Eigen::Index>(6 * k);
      group.alone.push_back(carriers[b].mobility);
      carriers[b].mobility = group.mobility.block<6, 6>(at, at);
    });
  }
}

void push_jointed(const model::Model& model, const model::State& state, std::span<const contact::BodyAnswer> answers,
                  const Interval& step, model::Scratch& scratch) {
  for (std::size_t g = 0; g < model.joint_groups.size(); ++g) {
    const JointGroup& group = model.joint_groups[g];
    JointStep& now = scratch.joints[g];
    Eigen::VectorXd impulse(static_cast<Eigen::Index>(6 * group.bodies.size()));
    for_bodies(group, [&](std::size_t k, std::size_t b) { part(impulse, k) = answers[b].impulse; });
    if (impulse.isZero(0)) continue;
    const Eigen::VectorXd change = now.system.moved(impulse);
    push_group(model, group, impulse, change, step.drag, scratch);
    change_rates(model, group, -now.system.rates(change), step.drag, now, scratch);
    close(model, state, group, step, now, scratch);
  }
}

void book_joints(const model::Model& model, model::State& state, model::Scratch& scratch) {
  if (model.joints.empty()) return;
  for (BodyStep& body : scratch.bodies) {
    body.pivot = {};
    body.pivot_work = body.pivot_late = 0;
  }
  for (std::size_t g = 0; g < model.joint_groups.size(); ++g) {
    const JointGroup& group = model.joint_groups[g];
    const JointStep& now = scratch.joints[g];
    const Eigen::VectorXd before = now.system.rates(velocities(scratch, group, &BodyStep::before)),
                          after = now.system.rates(velocities(scratch, group, &BodyStep::after));
    const std::vector<Pose> pose = poses(scratch, group);
    for (const JointPlace& place : group.joints) {
      const auto j = static_cast<std::size_t>(place.number);
      const std::array<Pose, 2> sides = rigid::sides_of(place, pose);
      const model::Wrench on_first = impulse_on_first(place, sides, now.impulses);
      model::JointAccount& account = state.joint_accounts[j];
      account.impulse += on_first.force;
      account.angular_impulse += on_first.moment - (sides[0].turn * place.joint.arm[0]).cross(on_first.force);
      if (!model.joints[j].is_support()) continue;
      BodyStep& body = nth(scratch.bodies, model.joints[j].body[0]);
      body.pivot.force += on_first.force;
      body.pivot.moment += on_first.moment;
      for_driven(model, model.joints[j], place, [&](Eigen::Index row, const model::Drive&) {
        body.pivot_work += 0.5 * now.impulses[row] * (before[row] + after[row]);
        body.pivot_late += 0.5 * now.impulses[row] * after[row];
      });
    }
  }
}

}  // namespace brunt::time
