// SPDX-License-Identifier: Apache-2.0
#include "rigid/body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/cross_matrix.hpp"

namespace brunt::rigid {
namespace {

/// The M of P' - P = dt M x J^-1 M, P' = 2 M - P, by Newton's method: its error is squared in each iteration, and that
/// of the start is of the order of the squared angle of a step.
Vec3 middle_momentum(const Body& body, const Vec3& start, double dt) {
  constexpr int most = 50;
  constexpr double rounding = 4e-16;
  const double half = 0.5 * dt;
  Vec3 M = start;
  for (int i = 0; i < most; ++i) {
    const Vec3 omega = body.inverse_inertia * M;
    const Vec3 missing = M - start - half * M.cross(omega);
    const Mat3 slope = Mat3::Identity() - half * (cross_matrix(M) * body.inverse_inertia - cross_matrix(omega));
    const Vec3 change = slope.partialPivLu().solve(missing);
    M -= change;
    if (change.norm() <= rounding * start.norm()) break;
  }
  return M;
}

}  // namespace

Body make_body(const MassProperties& mass) {
  constexpr double no_inertia = 1e-12;
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(mass.inertia);
  Vec3 inverse = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    if (axes.eigenvalues()[i] > no_inertia * axes.eigenvalues()[2]) inverse[i] = 1 / axes.eigenvalues()[i];
  return {mass, axes.eigenvectors() * inverse.asDiagonal() * axes.eigenvectors().transpose()};
}

Mat3 inverse_inertia_now(const Body& body, const BodyState& state) {
  const Mat3 R = state.orientation.toRotationMatrix();
  return R * body.inverse_inertia * R.transpose();
}

Vec3 angular_velocity(const Body& body, const BodyState& state) {
  const Eigen::Quaterniond& q = state.orientation;
  return q * (body.inverse_inertia * (q.conjugate() * state.angular_momentum));
}

Vec3 angular_momentum_of(const Body& body, const BodyState& state, const Vec3& angular_velocity) {
  const Eigen::Quaterniond& q = state.orientation;
  return q * (body.mass.inertia * (q.conjugate() * angular_velocity));
}

double kinetic_energy(const Body& body, const BodyState& state) {
  return 0.5 * body.mass.mass * state.velocity.squaredNorm() +
         0.5 * state.angular_momentum.dot(angular_velocity(body, state));
}

void move(const Body& body, double dt, BodyState& state) {
  state.displacement += dt * state.velocity;
  const Vec3 before = state.orientation.conjugate() * state.angular_momentum;
  const Vec3 half_turn = 0.5 * dt * (body.inverse_inertia * middle_momentum(body, before, dt));
  // cay(2 h) is the rotation of the quaternion (1, h)/|(1, h)|
  const Eigen::Quaterniond turn(1, half_turn[0], half_turn[1], half_turn[2]);
  state.orientation = (state.orientation * turn).normalized();
}

}  // namespace brunt::rigid
