// SPDX-License-Identifier: Apache-2.0
#include "rigid/joint.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace brunt::rigid {

Joint make_revolute(const std::array<Vec3, 2>& arm, const Vec3& axis) {
  Joint joint{.kind = JointKind::revolute, .arm = arm, .axis = axis.normalized()};
  joint.across[0] = joint.axis.unitOrthogonal();
  joint.across[1] = joint.axis.cross(joint.across[0]);
  return joint;
}

std::size_t rows_of(const Joint& joint) {
  if (joint.kind == JointKind::revolute) return most_joint_rows;
  return static_cast<std::size_t>(std::ranges::count(joint.holds, true));
}

std::size_t joint_rows(const Joint& joint, const std::array<Pose, 2>& pose, std::span<JointRow, most_joint_rows> rows) {
  const std::array<Vec3, 2> arm{pose[0].turn * joint.arm[0], pose[1].turn * joint.arm[1]};
  const Vec3 apart = pose[0].centre + arm[0] - pose[1].centre - arm[1];
  std::size_t count = 0;
  for (int c = 0; c < 3; ++c) {
    if (!nth(joint.holds, c)) continue;
    const Vec3 along = Vec3::Unit(c);
    rows[count++] = {.gap = apart[c], .shift = {along, -along}, .turn = {arm[0].cross(along), -arm[1].cross(along)}};
  }
  if (joint.kind != JointKind::revolute) return count;
  const Vec3 axis = pose[0].turn * joint.axis;
  for (const Vec3& across : joint.across) {
    const Vec3 other = pose[1].turn * across, about = axis.cross(other);
    rows[count++] = {.gap = axis.dot(other), .turn = {about, -about}};
  }
  return count;
}

double joint_angle(const Joint& joint, const std::array<Pose, 2>& pose) {
  const Vec3 start = pose[0].turn * joint.across[0], now = pose[1].turn * joint.across[0];
  const Vec3 axis = pose[0].turn * joint.axis;
  return std::atan2(start.cross(now).dot(axis), start.dot(now));
}

}  // namespace brunt::rigid
