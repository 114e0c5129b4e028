// SPDX-License-Identifier: Apache-2.0
// Joints of rigid bodies in a model: constants of a run, sums over the steps, and data of one step. Like bodies, every
// rank has all of them with the same bits.
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "model/rigid_body.hpp"
#include "rigid/joint_group.hpp"

namespace brunt::model {

/// A joint of the scene, or the point of a body at which supports hold and drive it.
struct BodyJoint {
  std::string name;                                    ///< empty: a support
  rigid::Joint joint;                                  ///< its arms follow when the bodies have been weighed
  std::array<LocalIndex, 2> body{no_index, no_index};  ///< in Model::bodies; no_index: the ground
  Vec3 point = Vec3::Zero();                           ///< at the start, less the mesh's origin
  std::array<std::optional<std::int32_t>, 3> drive{};  ///< of x, y, z of a pivot: index into Model::supports.drives
  double size = 0;                                     ///< of the bodies about the point [length]
  [[nodiscard]] bool is_support() const { return joint.kind == rigid::JointKind::pivot; }
};

/// Sums over the steps since t = 0, of what the joint gives to its first body. Doubles only, as in BodyAccount.
struct JointAccount {
  Vec3 impulse = Vec3::Zero();          ///< [momentum]
  Vec3 angular_impulse = Vec3::Zero();  ///< about the joint's point [mass length^2/time]
};
constexpr int joint_account_width = sizeof(JointAccount) / sizeof(double);

/// Data of one step of a group of bodies.
struct JointStep {
  rigid::JointSystem system;
  Eigen::VectorXd wanted;    ///< gaps at x_{n+1}, a row each
  Eigen::VectorXd impulses;  ///< of the step so far
};

}  // namespace brunt::model
