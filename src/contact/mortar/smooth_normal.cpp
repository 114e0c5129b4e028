// SPDX-License-Identifier: Apache-2.0
#include "smooth_normal.hpp"

#include "add_block.hpp"
#include "contact/mortar/corners.hpp"
#include "normal_change.hpp"

namespace brunt::contact {

namespace {

/// Derivative of v/|v| for a vector of this length and direction.
Mat3 unit_slope(const Vec3& unit, double length) {
  return (Mat3::Identity() - unit * unit.transpose()) / length;
}

bool has_area(FacetCorners corners) {
  SlavePlane plane;
  return make_slave_plane(corners, plane);
}

}  // namespace

SmoothNormal::SmoothNormal(const MortarSurfaces& surfaces, LocalIndex master, const std::array<double, 4>& weights,
                           std::span<const Vec3> x)
    : surfaces_(surfaces), master_(master), weights_(weights), x_(x) {
  const auto facet = static_cast<std::size_t>(master);
  const FacetNodes& patches = surfaces.master_patches.of_corner[facet];
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < patches.size() && patches[c] != no_index; ++c) {
    Vec3 of_patch = Vec3::Zero();
    for (const LocalIndex other : surfaces.master_patches.facets.row(patches[c]))
      if (const CornersOf corners(nth(surfaces.master, other), x); has_area(corners.span()))
        of_patch += NormalChange(corners.span()).normal();
    size_[c] = of_patch.norm();
    at_corner_[c] = of_patch / size_[c];
    sum += weights[c] * at_corner_[c];
  }
  const double size = sum.norm();
  normal_ = sum / size;
  across_ = unit_slope(normal_, size);
}

void SmoothNormal::add_slopes(NodeBlocks<Mat3>& slopes) const {
  const FacetNodes& patches = nth(surfaces_.master_patches.of_corner, master_);
  for (std::size_t c = 0; c < patches.size() && patches[c] != no_index; ++c) {
    const Mat3 left = weights_[c] * across_ * unit_slope(at_corner_[c], size_[c]);
    for (const LocalIndex other : surfaces_.master_patches.facets.row(patches[c])) {
      const FacetNodes& nodes = nth(surfaces_.master, other);
      const CornersOf corners(nodes, x_);
      if (!has_area(corners.span())) continue;
      const NormalChange normal(corners.span());
      for (std::size_t k = 0; k < corners.count; ++k) add_block(slopes, nodes[k], Mat3(left * normal.by_corner(k)));
    }
  }
}

}  // namespace brunt::contact
