// SPDX-License-Identifier: Apache-2.0
// Bodies with held and driven degrees of freedom.
#include "rigid/support.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace brunt;
using namespace brunt::rigid;

namespace {

/// No axis of symmetry along x, y or z.
Body skew_body() {
  Mat3 inertia;
  inertia << 2.0, 0.3, -0.2, 0.3, 3.0, 0.4, -0.2, 0.4, 3.5;
  return make_body({2.0, Vec3::Zero(), inertia});
}

BodyState spinning(const Body& body, const Vec3& spin) {
  BodyState state;
  state.angular_momentum = angular_momentum_of(body, state, spin);
  return state;
}

Support holding(std::initializer_list<Vec3> turns) {
  const std::vector<Vec3> held(turns);
  return make_support({}, held);
}

}  // namespace

TEST_CASE("held directions need not be independent nor of length 1") {
  const std::vector<Vec3> shift{{2, 0, 0}, {-1, 0, 0}, {1, 3, 0}};
  const Support support = make_support(shift, {});
  CHECK(support.holds_shift);
  CHECK_FALSE(support.holds_turn);
  CHECK((support.free_shift - Mat3(Vec3(0, 0, 1).asDiagonal())).norm() < 1e-15);
  CHECK(support.free_turn == Mat3::Identity());
  CHECK(holding({Vec3::UnitX(), {1, 1, 0}, {1, 1, 1}}).free_turn.isZero(0));
}

TEST_CASE("with nothing held the angular velocity is that of the free body") {
  const Body body = skew_body();
  const BodyState state = spinning(body, {0.3, -0.2, 0.7});
  const Vec3 spin = supported_spin(Mat3::Identity(), inertia_now(body, state), state.angular_momentum, Vec3::Zero());
  CHECK((spin - Vec3(0.3, -0.2, 0.7)).norm() < 1e-15);
}

TEST_CASE("a body on an axle turns by the same angle in all steps, and its energy stays") {
  const Body body = skew_body();
  const Vec3 axis = Vec3(1, 2, 2) / 3;
  const Support support = holding({axis.unitOrthogonal(), axis.cross(axis.unitOrthogonal())});
  BodyState state = spinning(body, 1.5 * axis);
  const double energy = kinetic_energy(body, state);
  for (int n = 0; n < 1000; ++n) move_supported(body, support.free_turn, Vec3::Zero(), 0.01, state);
  CHECK(kinetic_energy(body, state) == Approx(energy).epsilon(1e-12));
  CHECK((angular_velocity(body, state) - 1.5 * axis).norm() < 1e-12);
  CHECK(state.orientation.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(15.0, axis))) < 1e-12);
}

TEST_CASE("the supports of a turning body supply the change of its angular momentum, at both halves of a step") {
  const Body body = skew_body();
  const Vec3 axis = Vec3(1, 2, 2) / 3;
  const double dt = 0.05, rate = 1.5;
  const auto momentum_at = [&](double angle) {
    const Mat3 R = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    return Vec3(rate * (R * body.mass.inertia * R.transpose() * axis));
  };
  const Support support = holding({axis.unitOrthogonal(), axis.cross(axis.unitOrthogonal())});
  for (const bool driven : {false, true}) {
    BodyState state = spinning(body, rate * axis);
    for (int n = 0; n < 100; ++n) {
      const Gyroscopic change = driven ? move_supported(body, Mat3::Zero(), rate * axis, dt, state)
                                       : move_supported(body, support.free_turn, Vec3::Zero(), dt, state);
      const double angle = rate * dt * n;
      CHECK((change.first_half - momentum_at(angle + 0.5 * rate * dt) + momentum_at(angle)).norm() < 1e-12);
      CHECK((change.second_half - momentum_at(angle + rate * dt) + momentum_at(angle + 0.5 * rate * dt)).norm() <
            1e-12);
      CHECK(std::abs(axis.dot(change.first_half)) < 1e-13);
    }
  }
}

TEST_CASE("a driven turn is met to rounding, small and large") {
  const Body body = skew_body();
  for (const double angle : {1e-12, 1e-5, 0.1, 1.0}) {
    BodyState state;
    const Vec3 axis = Vec3(2, -1, 2) / 3;
    move_supported(body, Mat3::Zero(), angle / 0.01 * axis, 0.01, state);
    CHECK((state.orientation.vec() - std::sin(0.5 * angle) * axis).norm() < 2e-16);
    CHECK((angular_velocity(body, state) - angle / 0.01 * axis).norm() < 1e-14 * (1 + angle / 0.01));
  }
}

TEST_CASE("with one axis held the energy is kept to second order, and nothing turns about that axis") {
  const Body body = skew_body();
  const Support support = holding({Vec3::UnitZ()});
  const auto error_with = [&](int steps) {
    BodyState state = spinning(body, {1.0, 0.5, 0});
    state.angular_momentum = inertia_now(body, state) * supported_spin(support.free_turn, inertia_now(body, state),
                                                                       state.angular_momentum, Vec3::Zero());
    const double energy = kinetic_energy(body, state);
    double error = 0;
    for (int n = 0; n < steps; ++n) {
      move_supported(body, support.free_turn, Vec3::Zero(), 10.0 / steps, state);
      error = std::max(error, std::abs(kinetic_energy(body, state) / energy - 1));
      CHECK(std::abs(angular_velocity(body, state)[2]) < 1e-13);
    }
    return error;
  };
  const double coarse = error_with(200), fine = error_with(400);
  CHECK(std::log2(coarse / fine) == Approx(2.0).margin(0.1));
  CHECK(fine < 1e-4);
}
