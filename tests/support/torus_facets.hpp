// SPDX-License-Identifier: Apache-2.0
// Outer surfaces of the two tori of reference-mortar.md, M8 and M9: ring radius 76, tube radius 24.
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/search/facet_tree.hpp"

namespace brunt::test {

struct FacetSurface {
  std::vector<contact::FacetNodes> facets;
  std::vector<Vec3> positions;
};

/// Turned, then moved.
struct Pose {
  Mat3 rotation = Mat3::Identity();
  Vec3 translation = Vec3::Zero();
  Vec3 operator()(const Vec3& x) const { return rotation * x + translation; }
};

/// `around` quads around the ring, half as many around the tube, numbered tube by tube.
inline FacetSurface torus_facets(int around, const Pose& pose) {
  constexpr double ring = 76, tube = 24, turn = 2 * std::numbers::pi;
  const int section = around / 2;
  FacetSurface surface;
  const auto node = [&](int i, int j) { return static_cast<LocalIndex>(i % around * section + j % section); };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < section; ++j) {
      const double u = turn * i / around, w = turn * j / section, radius = ring + tube * std::cos(w);
      surface.positions.push_back(pose(Vec3(radius * std::cos(u), radius * std::sin(u), tube * std::sin(w))));
      surface.facets.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  return surface;
}

/// The pose of M9 in which two tori lie on each other, axes z.
inline Pose stacked() {
  return {Mat3::Identity(), Vec3(6, 4, 46)};
}

/// Axis along -y: +90 degrees about x.
inline Mat3 upright() {
  return (Mat3() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
}

/// Upright, then +45 degrees about z.
inline Mat3 upright_turned() {
  const double s = std::numbers::sqrt2 / 2;
  return (Mat3() << s, -s, 0, s, s, 0, 0, 0, 1).finished() * upright();
}

}  // namespace brunt::test
