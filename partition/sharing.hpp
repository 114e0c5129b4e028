// SPDX-License-Identifier: Apache-2.0
// The nodes shared between parts.
#pragma once
#include <span>
#include <vector>

#include "core/ragged.hpp"
#include "mesh/mesh.hpp"

namespace brunt::partition {

struct Sharing {
  std::vector<Rank> owner;         ///< of each node: part of its element with the lowest number, 0 without elements
  std::vector<LocalIndex> shared;  ///< nodes of two parts or more, ascending
  Ragged<Rank> holders;            ///< those parts ascending, one row for each of `shared`
};

/// part: of each element over all blocks in order.
Sharing share_nodes(const mesh::Mesh& mesh, std::span<const Rank> part);

}  // namespace brunt::partition
