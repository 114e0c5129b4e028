// SPDX-License-Identifier: Apache-2.0
// Initial extents of the parts of a scene.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// Least and greatest coordinates in the scene's own frame [length]; infinite, high below low, of nothing.
struct Extent {
  std::array<double, 3> low, high;
};

/// Of the nodes of each block over all ranks, after the placement of bodies and `initial_overlap: move`. Collective;
/// the same on all ranks and for any number of them.
std::vector<Extent> part_extents(const Prepared& run);

/// The box around all.
Extent together(std::span<const Extent> extents);

}  // namespace brunt::app
