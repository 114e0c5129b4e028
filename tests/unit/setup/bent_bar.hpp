// SPDX-License-Identifier: Apache-2.0
// A bar bent into a ring whose ends lie inside each other, or do not quite meet: one body that overlaps itself.
#pragma once
#include <cmath>
#include <numbers>

#include "mesh/primitives.hpp"

namespace brunt::test {

constexpr double ring_radius = 2.25;  ///< of the bar's centre line

constexpr std::size_t bent_bar_nodes = 12;  ///< inside the other end

/// 12 x 2 x 2 elements, cross-section 1 x 0.5; its ends overlap by `overlap` along the centre line (< 0: a gap). Inside
/// the other end are six nodes of each end: three in its middle and three on its inner side, for facets are chords;
/// those on its outer side are outside.
inline mesh::Mesh bent_bar(double overlap) {
  mesh::Mesh mesh = mesh::box("a", {1, 1, 0.5}, {12, 2, 2});
  const double around = 2 * std::numbers::pi + overlap / ring_radius;
  for (Vec3& x : mesh.coordinates) {
    const double radius = ring_radius - 0.25 + x.z(), angle = around * x.x();
    x = Vec3(radius * std::sin(angle), x.y(), radius * std::cos(angle));
  }
  return mesh;
}

/// Are these the depths of those nodes behind the other end's face?
inline bool is_bent_bar_depth(double depth, double overlap) {
  const auto at = [&](double radius) { return std::abs(depth - radius * std::sin(overlap / ring_radius)) < 1e-12; };
  return at(ring_radius) || at(ring_radius - 0.25);
}

}  // namespace brunt::test
