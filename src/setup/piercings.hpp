// SPDX-License-Identifier: Apache-2.0
// Edges of one solid that pass through another although no node of either is inside: closest points do not show this.
#pragma once
#include <array>
#include <vector>

#include "setup/solids.hpp"

namespace brunt::setup {

struct PiercingEdge {
  std::array<LocalIndex, 2> edge{};
  std::size_t face = 0;  ///< of the solid that the edge passes through
};

/// Edges of `one` of which a part is deeper inside `other` than `touching`, except those with an end in `inside`, and
/// those through faces with a corner in `inside`: these are reported as nodes. inside: a flag for each node of the
/// mesh.
std::vector<PiercingEdge> piercing_edges(const mesh::Mesh& mesh, const Solid& one, const Solid& other,
                                         const std::vector<char>& inside,
                                         const contact::Tolerances& tolerances = contact::standard_tolerances);

}  // namespace brunt::setup
