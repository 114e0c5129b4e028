// SPDX-License-Identifier: Apache-2.0
// Free placements as starting points of walks: straight translations, and rotations about the centroid, each to its
// first free placement, in axes that rotate with the bodies.
//
// Directions are the points of a grid on the surface of a cube in principal axes (26 on the coarsest grid: 6 faces, 12
// edges, 8 corners). The set is symmetric, so signs and order of the axes do not matter. If moments are equal within a
// thousandth, the missing axes come from the line between the centroids, from the other body, and last from the file.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "depth/encounter.hpp"

namespace brunt::depth {

struct Start {
  RigidMotion motion;  ///< free
  double length = 0;   ///< in the metric [length]
};

struct StartOptions {
  Metric metric = Metric::displacement;
  int grid = 1;              ///< directions in B's axes: 24 grid^2 + 2
  bool careful = false;      ///< 32 rotations instead of 14; for translations the grid in A's axes as well
  double march = 0.1;        ///< step, in units of A's radius (rotations: of 1 rad)
  double reach = 3;          ///< searches end at this multiple of the shortest length found so far
  double nothing_below = 0;  ///< placements below this length collide: searches begin there [length]
  /// Length of a free motion that is known: searches end at `reach` times it from the beginning [length].
  double known = std::numeric_limits<double>::infinity();
  Mat3 basis = Mat3::Identity();  ///< of admitted translations, see LocalProblem
};

/// Principal axes of a body, completed where they are not unique. In the axes in which `link` and `other` are given.
[[nodiscard]] Mat3 unique_axes(const Body& body, const Mat3& into, std::span<const Vec3> others);

/// Sorted by length; each bisected to an eighth of the search step.
[[nodiscard]] std::vector<Start> find_starts(Encounter& encounter, const StartOptions& options);

/// The motion itself if it is free, otherwise moved outwards along its own screw to at most three times its length;
/// otherwise length < 0.
[[nodiscard]] Start freed(Encounter& encounter, Metric metric, const RigidMotion& motion);

}  // namespace brunt::depth
