// SPDX-License-Identifier: Apache-2.0
// Two triangles: do they have a common point, and where are they nearest to each other.
#pragma once
#include <array>

#include "brunt/core/types.hpp"

namespace brunt::geometry {

/// Corners [length]. A triangle without area is the segment or the point that it covers.
using Triangle = std::array<Vec3, 3>;

/// Whether the closed triangles have a common point: touching in one point counts, and so does a coplanar overlap.
/// The answer is exact for the coordinates given: signs of determinants come from a floating-point filter, and from
/// exact sums where the filter cannot decide (Shewchuk 1997). It needs |coordinate| between 1e-90 and 1e90, or 0. What
/// is not finite crosses nothing.
bool triangles_cross(const Triangle& a, const Triangle& b);

struct NearestPoints {
  double distance = 0;                            ///< 0 exactly where triangles_cross [length]
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  ///< [length]; one point where the distance is 0
};

/// Nearest points of the closed triangles: the least over all vertex-face and edge-edge pairs. The distance is exact to
/// rounding of the coordinates. Where several pairs of points are nearest (parallel faces) it is one of them.
NearestPoints nearest_points(const Triangle& a, const Triangle& b);

/// The same where the distance is below `nearer_than`, to the same bits; otherwise the distance returned is some number
/// >= `nearer_than`, and the points are of no use.
NearestPoints nearest_points(const Triangle& a, const Triangle& b, double nearer_than);

/// The point of the closed triangle nearest to p, exact to rounding.
Vec3 nearest_point(const Triangle& triangle, const Vec3& p);

}  // namespace brunt::geometry
