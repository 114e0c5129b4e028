// SPDX-License-Identifier: Apache-2.0
// Which parts touch which nodes.
#pragma once
#include <span>
#include <vector>

#include "brunt/core/ragged.hpp"
#include "brunt/mesh/mesh.hpp"

namespace brunt::partition {

struct Sharing {
  std::vector<Rank> owner;         ///< of each node: part of the lowest element that touches it, 0 where none does
  std::vector<LocalIndex> shared;  ///< nodes that two parts or more touch, ascending
  Ragged<Rank> holders;            ///< those parts ascending, a row for each of `shared`
};

/// part: of each element over all blocks in order.
Sharing share_nodes(const mesh::Mesh& mesh, std::span<const Rank> part);

}  // namespace brunt::partition
