// SPDX-License-Identifier: Apache-2.0
#include "rigid/support.hpp"

#include <Eigen/LU>

#include "rigid/rotation.hpp"

namespace brunt::rigid {
namespace {

/// Projector onto the directions left free by these; `any`: whether there are any.
Mat3 free_of(std::span<const Vec3> held) {
  constexpr double dependent = 1e-9;  // of a unit vector: a smaller remainder is rounding
  Mat3 free = Mat3::Identity();
  int directions = 3;
  for (const Vec3& one : held) {
    const Vec3 rest = free * one.normalized();
    if (rest.norm() <= dependent) continue;
    free -= rest.normalized() * rest.normalized().transpose();
    --directions;
  }
  return directions > 0 ? free : Mat3(Mat3::Zero());
}

Mat3 inertia_at(const Body& body, const Eigen::Quaterniond& orientation) {
  const Mat3 R = orientation.toRotationMatrix();
  return R * body.mass.inertia * R.transpose();
}

}  // namespace

Support make_support(std::span<const Vec3> held_shift, std::span<const Vec3> held_turn) {
  return {free_of(held_shift), free_of(held_turn), !held_shift.empty(), !held_turn.empty()};
}

Mat3 supported_mobility(const Mat3& free_turn, const Mat3& inertia) {
  const Mat3& P = free_turn;
  if (P.isZero(0)) return P;
  // constrained axes get a moment of inertia of the body's magnitude, so that the matrix is regular
  const Mat3 others = Mat3::Identity() - P;
  const Mat3 along_free = P * inertia * P + inertia.trace() / 3 * others;
  return P * along_free.inverse() * P;
}

Vec3 supported_spin(const Mat3& free_turn, const Mat3& inertia, const Vec3& angular_momentum, const Vec3& given) {
  return given + supported_mobility(free_turn, inertia) * (angular_momentum - inertia * given);
}

Mat3 inertia_now(const Body& body, const BodyState& state) {
  return inertia_at(body, state.orientation);
}

Gyroscopic move_supported(const Body& body, const Mat3& free_turn, const Vec3& given, double dt, BodyState& state) {
  constexpr int most = 50;
  constexpr double rounding = 4e-16;
  state.displacement += dt * state.velocity;
  const Eigen::Quaterniond start = state.orientation;
  const Vec3 l = state.angular_momentum;
  Vec3 omega = supported_spin(free_turn, inertia_at(body, start), l, given);
  Mat3 middle = Mat3::Zero();
  for (int i = 0; i < most; ++i) {
    middle = inertia_at(body, (rotation_by(0.5 * dt * omega) * start).normalized());
    const Vec3 next = supported_spin(free_turn, middle, l, given);
    const double change = (next - omega).norm();
    omega = next;
    if (change <= rounding * omega.norm()) break;
  }
  state.orientation = (rotation_by(dt * omega) * start).normalized();
  const Mat3 inertia = inertia_at(body, state.orientation);
  state.angular_momentum = inertia * supported_spin(free_turn, inertia, l, given);
  const Vec3 in_the_middle = middle * omega;
  return {in_the_middle - l, state.angular_momentum - in_the_middle};
}

}  // namespace brunt::rigid
