// SPDX-License-Identifier: Apache-2.0
#include "depth/rigid_motion.hpp"

#include <cmath>

namespace brunt::depth {
namespace {

constexpr double no_rotation = 1e-150;  // of |v|: its square is still a normal number

/// The same rotation with w >= 0.
Eigen::Quaterniond short_way(const Eigen::Quaterniond& q) {
  return q.w() < 0 ? Eigen::Quaterniond(-q.coeffs()) : q;
}

double half_angle(const Eigen::Quaterniond& q) {
  return std::atan2(q.vec().norm(), q.w());
}

}  // namespace

Eigen::Quaterniond rotation_of(const Vec3& w) {
  const double angle = w.norm();
  const double over = angle > no_rotation ? std::sin(0.5 * angle) / angle : 0.5;
  Eigen::Quaterniond turn;
  turn.w() = std::cos(0.5 * angle);
  turn.vec() = over * w;
  return turn;
}

Vec3 rotation_vector(const Eigen::Quaterniond& turn) {
  const Eigen::Quaterniond q = short_way(turn);
  const double sine = q.vec().norm();
  return sine > no_rotation ? Vec3((2 * half_angle(q) / sine) * q.vec()) : Vec3(2 * q.vec());
}

Mat3 rotation_less_identity(const Eigen::Quaterniond& turn) {
  const double w = turn.w();
  const Vec3 v = turn.vec();
  Mat3 D = 2 * v * v.transpose();
  D.diagonal() << -2 * (v[1] * v[1] + v[2] * v[2]), -2 * (v[2] * v[2] + v[0] * v[0]), -2 * (v[0] * v[0] + v[1] * v[1]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    D(k, j) += 2 * w * v[i];
    D(j, k) -= 2 * w * v[i];
  }
  return D;
}

RigidMotion motion_between(const Placement& from, const Placement& to, const Vec3& centroid) {
  const Mat3 relative = from.rotation.transpose() * to.rotation;
  return {short_way(Eigen::Quaterniond(relative).normalized()),
          from.rotation.transpose() * (to(centroid) - from(centroid))};
}

Placement moved(const Placement& from, const RigidMotion& motion, const Vec3& centroid) {
  const Mat3 D = rotation_less_identity(motion.turn);
  return {from.rotation + from.rotation * D, from.translation + from.rotation * (motion.shift - D * centroid)};
}

RigidMotion compose(const RigidMotion& first, const RigidMotion& second) {
  return {short_way((second.turn * first.turn).normalized()), first.shift + second.shift};
}

Screw screw_of(const RigidMotion& motion) {
  const Eigen::Quaterniond q = short_way(motion.turn);
  const double sine = q.vec().norm();
  Screw screw;
  if (sine <= no_rotation) {
    screw.slide = motion.shift.norm();
    if (screw.slide > 0) screw.axis = motion.shift / screw.slide;
    return screw;
  }
  screw.axis = q.vec() / sine;
  screw.angle = 2 * half_angle(q);
  screw.slide = motion.shift.dot(screw.axis);
  const Vec3 across = motion.shift - screw.slide * screw.axis;
  screw.point = 0.5 * (across + (q.w() / sine) * screw.axis.cross(across));
  return screw;
}

RigidMotion along_screw(const RigidMotion& motion, double s) {
  const Eigen::Quaterniond q = short_way(motion.turn);
  const double sine = q.vec().norm();
  if (sine <= no_rotation) return {Eigen::Quaterniond::Identity(), s * motion.shift};
  const Vec3 axis = q.vec() / sine;
  const double half = half_angle(q), slide = motion.shift.dot(axis), rest = (1 - s) * half;
  const Vec3 across = motion.shift - slide * axis;
  const double ratio = std::sin(s * half) / sine;
  RigidMotion part;
  part.turn.w() = std::cos(s * half);
  part.turn.vec() = ratio * q.vec();
  part.shift = s * slide * axis + ratio * (std::cos(rest) * across - std::sin(rest) * axis.cross(across));
  return part;
}

}  // namespace brunt::depth
