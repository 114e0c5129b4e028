// SPDX-License-Identifier: Apache-2.0
// Triangles without area: generators write them where an edge has a point of a neighbour in it.
#pragma once
#include <cstdint>

#include "brunt/core/triangle_surface.hpp"

namespace brunt::geometry {

/// Removes triangles whose corners lie in one line (has_area in closed_surface.hpp). The longest side of such a
/// triangle is shared with a neighbour; the corner opposite to it lies in this side and divides the neighbour into two
/// triangles, which replace both. Points, the surface as a set of points, and its volume stay. Returns the number of
/// sides that were replaced. Triangles stay where the edge is not that of two triangles, or the new one exists already.
std::int64_t flip_slivers(TriangleSurface& surface);

}  // namespace brunt::geometry
