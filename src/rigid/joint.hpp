// SPDX-License-Identifier: Apache-2.0
// Joints between two rigid bodies, or of a body and the ground: conditions g = 0 on their places and orientations, one
// row each. With p the joint's point as a point of the first (a) and of the second body (b),
//   ball      g = p_a - p_b,
//   revolute  the same, and (R_a u) . (R_b w_1), (R_a u) . (R_b w_2): the axis u of the first body stays normal to two
//             directions w of the second,
//   pivot     components of p_a - p_b in space: supports and drives of one point of a body.
// The rate of g is G (V, omega) of both bodies; rows of the axis have arms of rotation alone.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "core/types.hpp"

namespace brunt::rigid {

enum class JointKind : std::int8_t { ball, revolute, pivot };

/// Place of the centre and orientation of a body; the ground: no shift and no turn.
struct Pose {
  Vec3 centre = Vec3::Zero();
  Mat3 turn = Mat3::Identity();
};

/// Constant in a run. Axes of bodies are those of space at the start.
struct Joint {
  JointKind kind = JointKind::ball;
  std::array<Vec3, 2> arm{Vec3::Zero(), Vec3::Zero()};  ///< of the point from the centre of a and b [length]
  Vec3 axis = Vec3::UnitZ();                            ///< u, unit, in the axes of a
  std::array<Vec3, 2> across{};                         ///< w, unit, in the axes of b
  std::array<bool, 3> holds{true, true, true};          ///< x, y, z of a pivot
};

constexpr std::size_t most_joint_rows = 5;

/// The slope of one row: derivatives by the shift of the centre and by the turn about it, of each body.
struct JointRow {
  double gap = 0;  ///< [length]; of the axis the sine of its angle
  std::array<Vec3, 2> shift{Vec3::Zero(), Vec3::Zero()}, turn{Vec3::Zero(), Vec3::Zero()};
};

/// A revolute joint with this axis, which need not have length 1; both bodies at the start.
[[nodiscard]] Joint make_revolute(const std::array<Vec3, 2>& arm, const Vec3& axis);

[[nodiscard]] std::size_t rows_of(const Joint& joint);

/// The rows of a joint in these places, in the order above; returns their number.
std::size_t joint_rows(const Joint& joint, const std::array<Pose, 2>& pose, std::span<JointRow, most_joint_rows> rows);

/// Angle of the second body relative to the first about the axis of a revolute joint, in (-pi, pi], 0 at the start.
[[nodiscard]] double joint_angle(const Joint& joint, const std::array<Pose, 2>& pose);

}  // namespace brunt::rigid
