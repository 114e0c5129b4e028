// SPDX-License-Identifier: Apache-2.0
// Exact translational penetration depth of two convex polytopes: the smallest overlap over the normals of the facets of
// the Minkowski difference, which are the face normals of both and the cross products of their edges (separating axes).
//
// For convex pairs DISP = PDt: the free placement has a separating plane, and a translation along its normal by the
// displacement of the deepest vertex is also free and not longer (README of this room).
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "core/triangle_surface.hpp"

namespace brunt::depth {

struct ConvexPiece {
  std::vector<Vec3> corners;  ///< [length]
  std::vector<Vec3> normals;  ///< unit, of the facets, one of each two opposite ones
  std::vector<Vec3> edges;    ///< unit directions, one of each two opposite ones
};

/// Convex hull of the points, which need not all be corners. For small sets: all triples are tested. Throws
/// std::invalid_argument for points in a plane.
[[nodiscard]] ConvexPiece convex_piece(std::span<const Vec3> points);

/// PDt of the pair [length]; for separated pieces minus a gap. Ends with some value not above `least` as soon as the
/// depth is known not to exceed it.
[[nodiscard]] double translation_depth(const ConvexPiece& a, const ConvexPiece& b, const Placement& a_in_b,
                                       double least = -std::numeric_limits<double>::infinity());

struct Narrowest {
  double depth = 0;          ///< [length]
  Vec3 axis = Vec3::Zero();  ///< unit, in the axes of b: direction of this overlap
};

/// The smallest PDt over all placements reached by a shift of a by sums s_i c_i, |s_i| <= 1, with c_i the columns of
/// `shifts` in the axes of b. Exact: PDt is the distance of a point from the boundary of the Minkowski difference, and
/// so a concave function of the shift while the pair overlaps. `least` as above.
[[nodiscard]] Narrowest narrowest_overlap(const ConvexPiece& a, const ConvexPiece& b, const Placement& a_in_b,
                                          const Mat3& shifts, double least = -std::numeric_limits<double>::infinity());

}  // namespace brunt::depth
