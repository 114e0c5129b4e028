// SPDX-License-Identifier: Apache-2.0
#include "geometry/face_weights.hpp"

#include <Eigen/LU>

#include "geometry/closest_point.hpp"

namespace brunt::geometry {

Vec3 middle_of(std::span<const Vec3> corners) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : corners) middle += corner / static_cast<double>(corners.size());
  return middle;
}

void shift_weights(std::span<const Vec3> corners, const Vec3& normal, const Vec3& by, std::array<double, 4>& weights) {
  const Vec3 middle = middle_of(corners);
  const Mat3 upright = normal * normal.transpose(), flat = Mat3::Identity() - upright;
  Mat3 spread = area_vector(corners).norm() * upright;  // makes the matrix regular, without influence on the result
  for (const Vec3& corner : corners) {
    const Vec3 arm = flat * (corner - middle);
    spread += arm * arm.transpose();
  }
  const Vec3 gradient = spread.inverse() * (flat * by);
  for (std::size_t i = 0; i < corners.size(); ++i) weights[i] += gradient.dot(flat * (corners[i] - middle));
}

}  // namespace brunt::geometry
