// SPDX-License-Identifier: Apache-2.0
// Triangles without area, up to rounding: generators write them where an edge has a point of a neighbour in it.
#pragma once
#include <cstdint>

#include "core/triangle_surface.hpp"

namespace brunt::geometry {

/// Removes triangles whose corners lie in one line: without area (has_area in closed_surface.hpp), or with a corner no
/// farther from the longest side than `tolerance` [length], that within which points are one (merge_points.hpp). The
/// normal of such a triangle is rounding, and may even point inwards. Its longest side is shared with a neighbour; the
/// corner opposite to it lies in this side and divides the neighbour into two triangles, which replace both. Points
/// stay, and the surface as a set of points within the tolerance. Returns the number of sides that were replaced.
/// Triangles stay where the edge is not that of two triangles, or the new one exists already.
std::int64_t flip_slivers(TriangleSurface& surface, double tolerance = 0);

}  // namespace brunt::geometry
