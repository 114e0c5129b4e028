// SPDX-License-Identifier: Apache-2.0
// The dual graph of a mesh: elements are its vertices, shared faces its edges, and of shells shared edges.
#pragma once
#include <span>
#include <vector>

#include "core/ragged.hpp"
#include "mesh/mesh.hpp"

namespace brunt::partition {

/// Row e: elements that share a face with element e, or an edge if both are shells, ascending; e counts over all blocks
/// in order. Every edge appears in both rows.
Ragged<LocalIndex> dual_graph(const mesh::Mesh& mesh);

/// Calls visit(nodes of the element, shape) for each element over all blocks in order.
template <class Visit>
void for_each_element(const mesh::Mesh& mesh, Visit visit) {
  for (const mesh::Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e)
      visit(
          std::span<const LocalIndex>(block.element(e), static_cast<std::size_t>(mesh::nodes_per_element(block.shape))),
          block.shape);
}

/// Number of elements in the blocks before each block; the last entry counts all.
std::vector<LocalIndex> first_of_block(const mesh::Mesh& mesh);

}  // namespace brunt::partition
