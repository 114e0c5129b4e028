// SPDX-License-Identifier: Apache-2.0
#include "partition/distribute.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "partition/packing.hpp"
#include "partition/piece.hpp"

namespace brunt::partition {

mesh::LocalMesh distribute(const comm::Communicator& ranks, const mesh::CanonicalMesh& whole,
                           std::span<const Rank> part, Rank root) {
  std::optional<Cutter> cutter;
  if (ranks.rank() == root) cutter.emplace(whole, part, ranks.size());
  mesh::LocalMesh own;  // of the root, which needs no message to itself
  const std::vector<std::byte> bytes = ranks.scatter(
      [&](Rank rank) {
        if (rank != root) return pack(cutter->piece(rank));
        own = cutter->piece(rank);
        return std::vector<std::byte>{};
      },
      root);
  return ranks.rank() == root ? std::move(own) : unpack(bytes);
}

}  // namespace brunt::partition
