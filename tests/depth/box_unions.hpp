// SPDX-License-Identifier: Apache-2.0
// Closed surfaces of unions of boxes: the faces between full and empty cells of the grid of all their planes.
#pragma once
#include <vector>

#include "core/triangle_surface.hpp"
#include "geometry/box.hpp"

namespace brunt::test {

/// Inner faces are removed; points are shared. Boxes that touch along an edge only make an edge of four triangles.
TriangleSurface surface_of_boxes(const std::vector<geometry::Box>& boxes);

/// Cells that `full` holds and `empty` does not.
TriangleSurface surface_of_boxes(const std::vector<geometry::Box>& full, const std::vector<geometry::Box>& empty);

geometry::Box box_between(const Vec3& low, const Vec3& high);

/// Eight corners of each.
std::vector<std::vector<Vec3>> corners_of(const std::vector<geometry::Box>& boxes);

}  // namespace brunt::test
