// SPDX-License-Identifier: Apache-2.0
// Shells of a closed surface against each other: which lie inside which.
#pragma once
#include <span>
#include <vector>

#include "brunt/geometry/closed_surface.hpp"

namespace brunt::geometry {

/// `shell_of`: the shell of each triangle. Sets volumes, and the faults of shells where `edges_sound`.
void check_shells(const TriangleSurface& surface, std::span<const LocalIndex> shell_of, bool edges_sound,
                  SurfaceFaults& faults);

}  // namespace brunt::geometry
