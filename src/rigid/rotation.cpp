// SPDX-License-Identifier: Apache-2.0
#include "rigid/rotation.hpp"

#include <cmath>

#include "core/cross_matrix.hpp"

namespace brunt::rigid {

Eigen::Quaterniond rotation_by(const Vec3& turn) {
  const double half = 0.5 * turn.norm();
  constexpr double small = 1e-4;  // x^4/120 is below rounding
  const double share = half < small ? 0.5 * (1 - half * half / 6) : 0.5 * std::sin(half) / half;
  return {std::cos(half), share * turn[0], share * turn[1], share * turn[2]};
}

Vec3 rotation_vector(Eigen::Quaterniond rotation) {
  if (rotation.w() < 0) rotation.coeffs() = -rotation.coeffs();
  const double sine = rotation.vec().norm();
  return sine > 0 ? Vec3(2 * std::atan2(sine, rotation.w()) / sine * rotation.vec()) : Vec3(Vec3::Zero());
}

Mat3 rotation_vector_slope(const Vec3& turn) {
  const double angle = turn.norm();
  constexpr double small = 1e-2;  // the next term of the series is angle^4/30240
  const double share =
      angle < small ? 1.0 / 12 + angle * angle / 720 : (1 - 0.5 * angle / std::tan(0.5 * angle)) / (angle * angle);
  const Mat3 cross = cross_matrix(turn);
  return Mat3::Identity() - 0.5 * cross + share * cross * cross;
}

Vec3 half_turn(const Eigen::Quaterniond& rotation) {
  return rotation.vec() / rotation.w();
}

Mat3 half_turn_slope(const Vec3& half_turn) {
  return 0.5 * (Mat3::Identity() - cross_matrix(half_turn) + half_turn * half_turn.transpose());
}

}  // namespace brunt::rigid
