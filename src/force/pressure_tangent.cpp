// SPDX-License-Identifier: Apache-2.0
#include "force/pressure_tangent.hpp"

#include "core/cross_matrix.hpp"

namespace brunt::force {

std::array<Mat3, 4> pressure_tangent(double pressure, std::span<const Vec3> corners) {
  // area = first x second / 2 with the two edges of a triangle from its first corner, or the diagonals of a
  // quadrilateral
  const bool triangle = corners.size() == 3;
  const Mat3 first = cross_matrix(triangle ? corners[1] - corners[0] : corners[2] - corners[0]);
  const Mat3 second = cross_matrix(triangle ? corners[2] - corners[0] : corners[3] - corners[1]);
  const double share = -pressure / static_cast<double>(corners.size());
  const Mat3 by_first = -0.5 * share * second, by_second = 0.5 * share * first;
  if (triangle) return {-by_first - by_second, by_first, by_second, Mat3::Zero()};
  return {-by_first, -by_second, by_first, by_second};
}

}  // namespace brunt::force
