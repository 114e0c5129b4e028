// SPDX-License-Identifier: Apache-2.0
// Triangulated surfaces and rigid placements, shared by the readers of surface files, geometry and penetration depth.
#pragma once
#include <array>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// Points and triangles. The corners of a triangle are counter-clockwise seen from outside.
struct TriangleSurface {
  std::vector<Vec3> points;                          ///< [length]
  std::vector<std::array<LocalIndex, 3>> triangles;  ///< corners, indices of points
};

/// A rigid placement: x -> rotation x + translation.
struct Placement {
  Mat3 rotation = Mat3::Identity();  ///< proper orthogonal
  Vec3 translation = Vec3::Zero();   ///< [length]
  [[nodiscard]] Vec3 operator()(const Vec3& x) const { return rotation * x + translation; }
  /// y -> rotation^T (y - translation)
  [[nodiscard]] Vec3 back(const Vec3& y) const { return rotation.transpose() * (y - translation); }
};

}  // namespace brunt
