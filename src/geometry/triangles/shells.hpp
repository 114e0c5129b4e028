// SPDX-License-Identifier: Apache-2.0
// Nesting of the shells of a closed surface.
#pragma once
#include <span>
#include <vector>

#include "geometry/triangles/closed_surface.hpp"

namespace brunt::geometry {

/// `shell_of`: the shell of each triangle. Sets volumes, and the errors of shells if `edges_sound`.
void check_shells(const TriangleSurface& surface, std::span<const LocalIndex> shell_of, bool edges_sound,
                  SurfaceFaults& faults);

}  // namespace brunt::geometry
