// SPDX-License-Identifier: Apache-2.0
// Merges nearly equal points of a surface: files store the corners of neighbouring triangles separately.
#pragma once
#include <cstdint>

#include "core/triangle_surface.hpp"

namespace brunt::geometry {

/// Default tolerances. A point that two triangles of a file compute in different ways differs by a few units in the
/// last place: 2^-24 of its largest coordinate (6e-8) in single precision, 2^-53 (1e-16) in double precision, or by the
/// digits of a text file. The ratios to the diagonal of the bounding box allow for several such errors and for texts
/// with six and nine digits, and are far below the features of a model. Far from the origin, the rounding of the
/// coordinates exceeds these ratios, and `merge_rounding` units are used.
constexpr double merge_ratio_single = 1e-6;  ///< of the diagonal, for coordinates of single precision
constexpr double merge_ratio_double = 1e-9;  ///< of the diagonal, for coordinates of double precision
constexpr double merge_rounding = 4;         ///< units of 2^-24 or 2^-53 of the largest coordinate

/// [length]
[[nodiscard]] double default_tolerance(const TriangleSurface& surface, bool single_precision);

struct MergedSurface {
  TriangleSurface surface;
  std::int64_t merged_points = 0;      ///< points that became another one
  std::int64_t dropped_triangles = 0;  ///< triangles that had two corners in one point then, and so no area
  double largest_distance = 0;         ///< from a point to the one that it became [length]
};

/// Merges all points connected by a chain in which neighbours are no farther apart than `tolerance` (equal points with
/// tolerance 0): the groups do not depend on the order of the points. A group becomes its first point in the order of
/// x, then y, then z. Points keep the order of the first members of their groups, triangles keep their order.
///
/// Linear in the number of points, apart from sorting. To guarantee this for any input, more than `crowded_cell`
/// different points in a cube of four tolerances form one group: a tolerance this large destroys the surface anyway. A
/// tolerance below 2^-50 of the bounding box is treated as 0.
[[nodiscard]] MergedSurface merge_points(const TriangleSurface& surface, double tolerance);

constexpr std::size_t crowded_cell = 1024;

}  // namespace brunt::geometry
