// SPDX-License-Identifier: Apache-2.0
// Linear conditions on a small motion of A: triangles that are close to each other must not intersect.
//
// A pair at the distance d with nearest points p_A, p_B and n = (p_A - p_B)/d remains separated under the small motion
// (tau, omega) about the present centroid of A if
//   n . (tau + omega x (p_A - c)) >= -d + margin.
// The plane through p_B with normal n separates the two triangles, so the condition is sufficient for a translation;
// the second order of the rotation is neglected. At corners the normal changes from step to step, so no cases need be
// distinguished (README of this room, after section 4 of Zhang, Kim, Manocha 2007).
#pragma once
#include <span>
#include <vector>

#include "depth/encounter.hpp"

namespace brunt::depth {

struct NearCondition {
  Vec3 normal = Vec3::Zero();  ///< n, from B to A
  Vec3 arm = Vec3::Zero();     ///< p_A - c [length]
  double distance = 0;         ///< d [length]
  double bound = 0;  ///< of n . (tau + omega x arm): min(0, margin - d), or more after `correct_bounds` [length]
  LocalIndex a = no_index, b = no_index;  ///< triangles
};

/// Work arrays that keep their capacity.
struct NearPairs {
  std::vector<geometry::NearPair> pairs;
  std::vector<NearCondition> conditions;  ///< in the axes of A at q_0

  /// All pairs of triangles closer than `band` [length] at the position given by the motion. Pairs whose nearest points
  /// agree within 1e-9 of A's size give one condition. Ordered by position, not by numbers of triangles.
  void find(const Encounter& encounter, const RigidMotion& motion, double band, double margin);
  /// Restores the bounds computed by `find`.
  void forget_corrections(double margin);
};

/// Gap of two triangles in common axes, as used by correct_bounds; -infinity if no axis has the direction of the unit
/// vector n, from b to a [length].
[[nodiscard]] double gap_of(const geometry::Triangle& a, const geometry::Triangle& b, const Vec3& n);

/// Unit vector from b to a along which the gap of two triangles in common axes is largest: a face normal, first of b,
/// or otherwise a cross product of edges. For separated triangles whose distance is so small that the difference of
/// their nearest points is rounding. Zero for two triangles without area in one line.
[[nodiscard]] Vec3 separating_axis(const geometry::Triangle& a, const geometry::Triangle& b);

/// Second-order correction: if the triangles of a condition are closer than `margin` after the small motion (tau,
/// omega) that led to `motion`, its bound is increased by the difference. The gap of two triangles is the largest over
/// the separating axes (two face normals, nine cross products of edges) within 60 degrees of n; it is negative for
/// intersecting triangles. Returns whether any bound was increased.
bool correct_bounds(const Encounter& encounter, const RigidMotion& motion, const Vec3& tau, const Vec3& omega,
                    double margin, std::span<NearCondition> conditions);

}  // namespace brunt::depth
