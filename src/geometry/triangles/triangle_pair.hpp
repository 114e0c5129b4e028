// SPDX-License-Identifier: Apache-2.0
// Two triangles: whether they have a common point, and their nearest points.
#pragma once
#include <array>

#include "core/types.hpp"

namespace brunt::geometry {

/// Corners [length]. A triangle without area is the segment or the point that it covers.
using Triangle = std::array<Vec3, 3>;

/// Whether the closed triangles have a common point, including a single point and a coplanar overlap. The answer is
/// exact for the given coordinates: signs of determinants are found by a floating-point filter, and by exact sums if
/// the filter cannot decide (Shewchuk 1997). Coordinates must be 0 or between 1e-90 and 1e90 in magnitude. Triangles
/// that are not finite cross nothing.
bool triangles_cross(const Triangle& a, const Triangle& b);

struct NearestPoints {
  double distance = 0;                            ///< 0 exactly where triangles_cross [length]
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  ///< [length]; one point where the distance is 0
};

/// Nearest points of the closed triangles: the minimum over all vertex-face and edge-edge pairs. The distance is exact
/// up to rounding of the coordinates. If several pairs are nearest (parallel faces), the result is one of them.
NearestPoints nearest_points(const Triangle& a, const Triangle& b);

/// The same if the distance is below `nearer_than`, with the same bits; otherwise the returned distance is some number
/// >= `nearer_than`, and the points are undefined.
NearestPoints nearest_points(const Triangle& a, const Triangle& b, double nearer_than);

/// The point of the closed triangle nearest to p, exact to rounding.
Vec3 nearest_point(const Triangle& triangle, const Vec3& p);

}  // namespace brunt::geometry
