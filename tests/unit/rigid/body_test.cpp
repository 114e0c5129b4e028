// SPDX-License-Identifier: Apache-2.0
// The free rigid body against the exact solution of Euler's equations (L. D. Landau, E. M. Lifshitz, Mechanics, 37).
#include "rigid/body.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/jacobi.hpp"

using namespace brunt;

namespace {

const Vec3 moments(1.0, 2.0, 3.5);

rigid::Body top() {
  return rigid::make_body({2.0, Vec3::Zero(), moments.asDiagonal()});
}

/// Angular velocity in body axes at time t, of moments I1 < I2 < I3 and angular momentum |l|^2 > 2 E I2.
Vec3 exact_spin(double energy, double l2, double t) {
  const double I1 = moments[0], I2 = moments[1], I3 = moments[2], e2 = 2 * energy;
  const double rate = std::sqrt((I3 - I2) * (l2 - e2 * I1) / (I1 * I2 * I3));
  const double k2 = (I2 - I1) * (e2 * I3 - l2) / ((I3 - I2) * (l2 - e2 * I1));
  const auto [sn, cn, dn] = support::jacobi(rate * t, std::sqrt(k2));
  return {std::sqrt((e2 * I3 - l2) / (I1 * (I3 - I1))) * cn, std::sqrt((e2 * I3 - l2) / (I2 * (I3 - I2))) * sn,
          std::sqrt((l2 - e2 * I1) / (I3 * (I3 - I1))) * dn};
}

Vec3 spin_in_body(const rigid::Body& body, const rigid::BodyState& state) {
  return state.orientation.conjugate() * rigid::angular_velocity(body, state);
}

rigid::BodyState spinning(const rigid::Body& body, const Vec3& spin) {
  rigid::BodyState state;
  state.angular_momentum = rigid::angular_momentum_of(body, state, spin);
  return state;
}

/// Largest error of the spin in body axes over the time `end`.
double error_with(int steps, double end) {
  const rigid::Body body = top();
  const Vec3 start(0.6, 0.0, 1.0);
  rigid::BodyState state = spinning(body, start);
  const double energy = rigid::kinetic_energy(body, state), l2 = state.angular_momentum.squaredNorm();
  double error = (spin_in_body(body, state) - exact_spin(energy, l2, 0)).norm();
  for (int n = 1; n <= steps; ++n) {
    rigid::move(body, end / steps, state);
    error = std::max(error, (spin_in_body(body, state) - exact_spin(energy, l2, end * n / steps)).norm());
  }
  return error;
}

}  // namespace

TEST_CASE("an unsymmetric top follows Jacobi's elliptic functions with order 2") {
  double before = error_with(200, 20.0);
  for (const int steps : {400, 800, 1600}) {
    const double error = error_with(steps, 20.0);
    CHECK(std::log2(before / error) == Approx(2.0).margin(0.05));
    before = error;
  }
  CHECK(before < 5e-4);  // 80 steps a unit of time, at 1.2 radians a unit
}

TEST_CASE(
    "energy and angular momentum of a free top stay to rounding over 10^5 steps, tumbling about its middle axis") {
  const rigid::Body body = top();
  rigid::BodyState state = spinning(body, {1e-3, 2.0, 1e-3});
  const double energy = rigid::kinetic_energy(body, state);
  const Vec3 l = state.angular_momentum;
  double drift = 0, least = 1, most = -1;
  for (int n = 0; n < 100000; ++n) {
    rigid::move(body, 0.01, state);
    drift = std::max(drift, std::abs(rigid::kinetic_energy(body, state) / energy - 1));
    const double along = spin_in_body(body, state)[1] / 2.0;
    least = std::min(least, along);
    most = std::max(most, along);
  }
  CHECK(state.angular_momentum == l);
  CHECK(drift < 2e-12);
  CHECK(std::abs(state.orientation.norm() - 1) < 1e-15);
  CHECK(most > 0.999);  // it turns over, again and again
  CHECK(least < -0.999);
}

TEST_CASE("a symmetric top precesses about its angular momentum at |l| / I") {
  const rigid::Body body = rigid::make_body({1.0, Vec3::Zero(), Vec3(2, 2, 3).asDiagonal()});
  rigid::BodyState state = spinning(body, {0.4, 0.0, 1.0});
  const Vec3 l = state.angular_momentum.normalized();
  const double rate = state.angular_momentum.norm() / 2;
  const int steps = 4000;
  const double turns = 3, dt = turns * 2 * std::numbers::pi / rate / steps;
  const Vec3 axis = Vec3::UnitZ() - l[2] * l;
  for (int n = 0; n < steps; ++n) rigid::move(body, dt, state);
  const Vec3 now = state.orientation * Vec3::UnitZ();
  CHECK((now - now.dot(l) * l - axis).norm() < 1e-4);
}

TEST_CASE("an impulse changes the energy by its work with the mean velocity, and the chord of a point is dt v") {
  const rigid::Body body = top();
  rigid::BodyState state = spinning(body, {0.3, -0.8, 1.1});
  state.velocity = {1, 2, 3};
  rigid::move(body, 0.05, state);
  const Vec3 point(0.3, -0.2, 0.9), impulse(0.4, 0.1, -0.7);
  const auto place = [&](const rigid::BodyState& at) {
    return Vec3(body.mass.centre + at.displacement + at.orientation * (point - body.mass.centre));
  };
  const Vec3 arm = place(state) - state.displacement;
  const auto velocity = [&] { return Vec3(state.velocity + rigid::angular_velocity(body, state).cross(arm)); };
  const double energy = rigid::kinetic_energy(body, state);
  const Vec3 before = velocity();
  state.velocity += impulse / body.mass.mass;
  state.angular_momentum += arm.cross(impulse);
  CHECK(rigid::kinetic_energy(body, state) - energy == Approx(0.5 * impulse.dot(before + velocity())).epsilon(1e-13));

  const auto chord_error = [&](double dt) {
    rigid::BodyState moved = state;
    rigid::move(body, dt, moved);
    return (place(moved) - place(state) - dt * velocity()).norm();
  };
  CHECK(chord_error(1e-3) / chord_error(5e-4) == Approx(4).epsilon(0.01));  // arms turn: of second order
}

TEST_CASE("a body without inertia about some axis does not turn about it; a mass point does not turn at all") {
  const rigid::Body rod = rigid::make_body({1.0, Vec3::Zero(), Vec3(2, 2, 0).asDiagonal()});
  rigid::BodyState state = spinning(rod, {1, 0, 5});
  for (int n = 0; n < 100; ++n) rigid::move(rod, 0.01, state);
  CHECK((rigid::angular_velocity(rod, state) - Vec3(1, 0, 0)).norm() < 1e-13);

  const rigid::Body point = rigid::make_body({1.0, Vec3::Zero(), Mat3::Zero()});
  rigid::BodyState still;
  still.velocity = {0, 0, 2};
  rigid::move(point, 0.5, still);
  CHECK(still.displacement == Vec3(0, 0, 1));
  CHECK(still.orientation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
}
