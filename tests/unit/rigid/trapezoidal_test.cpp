// SPDX-License-Identifier: Apache-2.0
#include "rigid/trapezoidal.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "rigid/rotation.hpp"

using namespace brunt;
using namespace brunt::rigid;

namespace {

Body uneven() {
  Mat3 inertia;
  inertia << 3, 0.2, -0.1, 0.2, 2, 0.3, -0.1, 0.3, 1.4;
  return make_body({2.0, Vec3::Zero(), inertia});
}

BodyState spinning() {
  BodyState state;
  state.orientation = rotation_by(Vec3(0.4, -0.7, 0.2));
  state.angular_momentum = Vec3(1, 5, -2);
  return state;
}

/// One step under the impulse of a moment, by Newton's method with the slope.
BodyState step(const Body& body, const BodyState& before, double dt, const Vec3& impulse) {
  Eigen::Quaterniond turn = rotation_by(dt * angular_velocity(body, before));
  MomentumAfter after;
  for (int i = 0; i < 20; ++i) {
    after = momentum_after(body, before, turn, dt);
    const Vec3 left = after.momentum - before.angular_momentum - impulse;
    turn = (rotation_by(-after.slope.partialPivLu().solve(left)) * turn).normalized();
  }
  BodyState state = before;
  state.orientation = (turn * before.orientation).normalized();
  state.angular_momentum = momentum_after(body, before, turn, dt).momentum;
  return state;
}

}  // namespace

TEST_CASE("the momentum at the end of a step: its slope is the derivative", "[oracle]") {
  const Body body = uneven();
  const BodyState before = spinning();
  const Eigen::Quaterniond turn = rotation_by(Vec3(0.5, 0.3, -0.6));
  const Mat3 slope = momentum_after(body, before, turn, 0.1).slope;
  constexpr double h = 1e-5;
  for (int c = 0; c < 3; ++c) {
    const Vec3 ahead = momentum_after(body, before, rotation_by(h * Vec3::Unit(c)) * turn, 0.1).momentum;
    const Vec3 behind = momentum_after(body, before, rotation_by(-h * Vec3::Unit(c)) * turn, 0.1).momentum;
    CHECK((slope.col(c) - (ahead - behind) / (2 * h)).norm() < 1e-8 * slope.norm());
  }
}

TEST_CASE("a body free of moments keeps momentum and energy, and goes as the explicit one does", "[oracle]") {
  const Body body = uneven();
  BodyState state = spinning(), other = state;
  const double energy = kinetic_energy(body, state);
  for (int i = 0; i < 100; ++i) {
    state = step(body, state, 0.02, Vec3::Zero());
    move(body, 0.02, other);
  }
  CHECK((state.angular_momentum - Vec3(1, 5, -2)).norm() < 1e-12);
  CHECK(kinetic_energy(body, state) == Approx(energy).epsilon(1e-13));
  CHECK(state.orientation.angularDistance(other.orientation) < 1e-11);
}

TEST_CASE("a moment's impulse does the work 2 h . impulse/dt", "[oracle]") {
  const Body body = uneven();
  const BodyState before = spinning();
  const Vec3 impulse(0.3, -0.2, 0.5);
  const BodyState after = step(body, before, 0.05, impulse);
  const Vec3 half = half_turn(after.orientation * before.orientation.conjugate());
  CHECK(kinetic_energy(body, after) - kinetic_energy(body, before) ==
        Approx(2 / 0.05 * half.dot(impulse)).epsilon(1e-12));
}
