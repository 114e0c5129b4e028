// SPDX-License-Identifier: Apache-2.0
#include "partition/distribute.hpp"

#include <optional>

#include "partition/packing.hpp"
#include "partition/piece.hpp"

namespace brunt::partition {

mesh::LocalMesh distribute(const comm::Communicator& ranks, const mesh::CanonicalMesh& whole,
                           std::span<const Rank> part, Rank root) {
  std::optional<Cutter> cutter;
  if (ranks.rank() == root) cutter.emplace(whole, part, ranks.size());
  return unpack(ranks.scatter([&](Rank rank) { return pack(cutter->piece(rank)); }, root));
}

}  // namespace brunt::partition
