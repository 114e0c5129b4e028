// SPDX-License-Identifier: Apache-2.0
// Normal of a faceted surface at a point of a facet, continuous across the edges of smooth patches: the normals at the
// facet's corners, interpolated. A node that slides over an edge of a facet would otherwise meet a jump of the
// direction of its force, and where it stands in a valley between two facets neither direction may balance it.
#pragma once
#include "contact/mortar/interface.hpp"

namespace brunt::contact {

class SmoothNormal {
 public:
  /// weights: shape functions of the master facet at the point.
  SmoothNormal(const MortarSurfaces& surfaces, LocalIndex master, const std::array<double, 4>& weights,
               std::span<const Vec3> x);

  [[nodiscard]] const Vec3& value() const { return normal_; }  ///< unit
  /// Derivative by the weight of a corner.
  [[nodiscard]] Vec3 by_weight(std::size_t corner) const { return across_ * at_corner_[corner]; }
  /// Adds the derivatives at fixed weights by all nodes around the facet to the last row.
  void add_slopes(NodeBlocks<Mat3>& slopes) const;

 private:
  const MortarSurfaces& surfaces_;
  LocalIndex master_;
  std::array<double, 4> weights_;
  std::span<const Vec3> x_;
  std::array<Vec3, 4> at_corner_;  ///< unit
  std::array<double, 4> size_{};   ///< of the sums of unit normals at the corners
  Vec3 normal_ = Vec3::Zero();
  Mat3 across_ = Mat3::Zero();  ///< derivative of the unit vector by the interpolated one
};

}  // namespace brunt::contact
