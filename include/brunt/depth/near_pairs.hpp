// SPDX-License-Identifier: Apache-2.0
// Linear conditions on a small motion of A: where pairs of triangles come near, they must not meet.
//
// A pair at the distance d with nearest points p_A, p_B and n = (p_A - p_B)/d keeps apart under the small motion
// (tau, omega) about the present centroid of A if
//   n . (tau + omega x (p_A - c)) >= -d + margin.
// The plane through p_B with normal n separates the two triangles, so the condition is sufficient for a translation;
// the rotation's second order is left out. At corners the normal turns from step to step, so that no case need be told
// apart (README of this room, after section 4 of Zhang, Kim, Manocha 2007).
#pragma once
#include <span>
#include <vector>

#include "brunt/depth/encounter.hpp"

namespace brunt::depth {

struct NearCondition {
  Vec3 normal = Vec3::Zero();  ///< n, from B to A
  Vec3 arm = Vec3::Zero();     ///< p_A - c [length]
  double distance = 0;         ///< d [length]
  double bound = 0;  ///< of n . (tau + omega x arm): min(0, margin - d), or more after `correct_bounds` [length]
  LocalIndex a = no_index, b = no_index;  ///< triangles
};

/// Buffers that keep their capacity.
struct NearPairs {
  std::vector<geometry::NearPair> pairs;
  std::vector<NearCondition> conditions;  ///< in the axes of A at q_0

  /// Of all pairs of triangles nearer than `band` [length] where the motion takes A. Pairs whose nearest points are the
  /// same within 1e-9 of A's size give one condition. Ordered by position, not by numbers of triangles.
  void find(const Encounter& encounter, const RigidMotion& motion, double band, double margin);
  /// Bounds as `find` gave them.
  void forget_corrections(double margin);
};

/// Gap of two triangles in common axes, as correct_bounds takes it; -infinity if no axis goes the way of the unit
/// vector n, from b to a [length].
[[nodiscard]] double gap_of(const geometry::Triangle& a, const geometry::Triangle& b, const Vec3& n);

/// Unit vector from b to a along which the gap of two triangles in common axes is greatest: of a face normal, of b
/// first, or else of a product of edges. For triangles that are free but so near that the difference of their nearest
/// points is rounding. Zero for two triangles without area in one line.
[[nodiscard]] Vec3 separating_axis(const geometry::Triangle& a, const geometry::Triangle& b);

/// Second-order correction: where the triangles of a condition are nearer than `margin` after the small motion (tau,
/// omega) that led to `motion`, its bound grows by what is missing. The gap of two triangles is the greatest over the
/// separating axes (two face normals, nine products of edges) that point the same way as n within 60 degrees; it is
/// negative where they cross. Whether any bound grew.
bool correct_bounds(const Encounter& encounter, const RigidMotion& motion, const Vec3& tau, const Vec3& omega,
                    double margin, std::span<NearCondition> conditions);

}  // namespace brunt::depth
