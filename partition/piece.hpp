// SPDX-License-Identifier: Apache-2.0
// Cuts the pieces of the ranks out of the whole mesh, one at a time.
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/ragged.hpp"
#include "mesh/canonical.hpp"
#include "mesh/local_mesh.hpp"
#include "partition/sharing.hpp"

namespace brunt::partition {

class Cutter {
 public:
  /// part: rank of each element in canonical order, each in [0, parts). Keeps a reference to `whole`.
  Cutter(const mesh::CanonicalMesh& whole, std::span<const Rank> part, int parts);

  mesh::LocalMesh piece(Rank rank);

 private:
  using RankSides = std::vector<std::vector<mesh::Side>>;  // by rank, ascending

  [[nodiscard]] std::size_t gid(const mesh::Side& side) const;
  [[nodiscard]] RankSides by_rank(const std::vector<mesh::Side>& sides, std::span<const Rank> part, int parts) const;
  /// Marks them in local_.
  [[nodiscard]] std::vector<LocalIndex> nodes_of(Rank rank);
  [[nodiscard]] std::vector<mesh::ExteriorFace> faces(const std::vector<mesh::Side>& sides) const;
  void cut_nodes(mesh::LocalMesh& piece, const std::vector<LocalIndex>& nodes, Rank rank) const;
  void cut_blocks(mesh::LocalMesh& piece, Rank rank) const;
  void cut_sets(mesh::LocalMesh& piece, Rank rank) const;

  const mesh::CanonicalMesh& whole_;
  std::vector<LocalIndex> first_;  // element gid of each block's first element
  std::vector<std::int32_t> body_;
  Sharing sharing_;
  std::vector<LocalIndex> untouched_;             // nodes without an element
  std::vector<std::vector<LocalIndex>> element_;  // gids by rank, ascending
  RankSides exterior_;
  std::map<std::string, RankSides> side_sets_;
  std::vector<LocalIndex> local_;  // of each node in the current piece, otherwise no_index
};

}  // namespace brunt::partition
