// SPDX-License-Identifier: Apache-2.0
// The point of a face nearest to a point in space. Faces are bilinear quadrilaterals or flat triangles.
//
//   3 --edge 2-- 2         xi runs from edge 3 (-1) to edge 1 (+1), eta from edge 0 to edge 2;
//   |            |         seen from outside the corners run counter-clockwise, so the normal
// edge 3       edge 1      d/dxi x d/deta points outward. A triangle has corners 0, 1, 2 and edges
//   |            |         0 (0-1), 1 (1-2), 2 (2-0); xi and eta are the weights of corners 1 and 2.
//   0 --edge 0-- 1
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/types.hpp"

namespace brunt::geometry {

/// The feature of the face that contains the nearest point.
enum class Region : std::int8_t { face, edge0, edge1, edge2, edge3, vertex0, vertex1, vertex2, vertex3 };

struct FacePoint {
  double xi = 0, eta = 0;
  std::array<double, 4> weights{};  ///< of the corners, sum 1; the last is 0 for a triangle
  Vec3 point = Vec3::Zero();
  Region region = Region::face;
};

/// Projections that miss the face by less than this share of its parametric width count as on it. A node above a shared
/// edge is then detected by both faces, and never by none.
constexpr double face_tolerance = 1e-6;

/// Corners of a face: three or four, in one order around it.
using Corners = std::span<const Vec3>;

/// Point of the face at (xi, eta).
std::array<double, 4> face_weights(std::size_t corner_count, double xi, double eta);

/// Unit normal at (xi, eta), outward for corners that run counter-clockwise seen from outside.
Vec3 face_normal(Corners corners, double xi, double eta);

/// Area-weighted normal [length^2]: half the cross product of the diagonals, which is the exact area vector of a
/// bilinear patch as well.
inline Vec3 area_vector(Corners corners) {
  if (corners.size() == 3) return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  return 0.5 * (corners[2] - corners[0]).cross(corners[3] - corners[1]);
}

/// Longest edge [length].
double longest_edge(Corners corners);

/// Extent of the face perpendicular to its longest edge: for a parallelogram or triangle the height above this edge; 0
/// without area [length].
double width(Corners corners);

/// Nearest point of the face to `x`. For a quadrilateral, Newton's method solves the stationarity conditions, starting
/// from the ratio of the triangle areas between the point and the edges (Heinstein et al. 2000, eq. 31; exact for
/// rectangles). If the iterate leaves the face, the nearest edge decides; if it does not converge (strongly warped or
/// nearly degenerate faces), refined sampling is used. Returns nullopt if the face has no area or a value is not
/// finite; never NaN.
std::optional<FacePoint> closest_point(const Vec3& x, Corners corners);

}  // namespace brunt::geometry
