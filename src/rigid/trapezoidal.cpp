// SPDX-License-Identifier: Apache-2.0
#include "rigid/trapezoidal.hpp"

#include "core/cross_matrix.hpp"
#include "rigid/rotation.hpp"

namespace brunt::rigid {

Vec3 body_spin(const Body& body, const BodyState& state) {
  return body.inverse_inertia * (state.orientation.conjugate() * state.angular_momentum);
}

MomentumAfter momentum_after(const Body& body, const BodyState& before, const Eigen::Quaterniond& turn, double dt) {
  const Vec3 half = half_turn(turn);
  const Mat3 before_axes = before.orientation.toRotationMatrix();
  const Mat3 axes = (turn * before.orientation).toRotationMatrix();
  const Vec3 spin = 4 / dt * (before_axes.transpose() * half) - body_spin(body, before);
  MomentumAfter after;
  after.momentum = axes * (body.mass.inertia * spin);
  after.slope = 4 / dt * axes * body.mass.inertia * before_axes.transpose() * half_turn_slope(half) -
                cross_matrix(after.momentum);
  return after;
}

}  // namespace brunt::rigid
