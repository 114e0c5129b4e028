// SPDX-License-Identifier: Apache-2.0
// Messages to ranks that are determined at run time, and the block layout in which files are written.
#pragma once
#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "core/ragged.hpp"

namespace brunt::comm {

/// Sends row r of `outgoing` to rank r; returns what every rank sent here, row by rank. Collective.
Ragged<std::byte> exchange_bytes(const Communicator& ranks, const Ragged<std::byte>& outgoing);

template <class T>
Ragged<T> exchange(const Communicator& ranks, const std::vector<std::vector<T>>& to_rank) {
  static_assert(std::is_trivially_copyable_v<T>);
  Ragged<std::byte> outgoing;
  for (const std::vector<T>& row : to_rank) {
    const auto* first = reinterpret_cast<const std::byte*>(row.data());
    outgoing.values.insert(outgoing.values.end(), first, first + row.size() * sizeof(T));
    outgoing.close_row();
  }
  const Ragged<std::byte> incoming = exchange_bytes(ranks, outgoing);
  Ragged<T> result;
  result.values.resize(incoming.values.size() / sizeof(T));
  if (!result.values.empty()) std::memcpy(result.values.data(), incoming.values.data(), incoming.values.size());
  for (LocalIndex r = 0; r < incoming.rows(); ++r)
    result.offsets.push_back(incoming.offsets[static_cast<std::size_t>(r) + 1] / static_cast<LocalIndex>(sizeof(T)));
  return result;
}

/// Entities 0..total-1 in equal contiguous blocks, for parallel reading and writing of files.
struct BlockLayout {
  GlobalIndex total = 0;
  int ranks = 1;
  [[nodiscard]] GlobalIndex first(Rank r) const { return total / ranks * r + std::min<GlobalIndex>(r, total % ranks); }
  [[nodiscard]] LocalIndex count(Rank r) const { return static_cast<LocalIndex>(first(r + 1) - first(r)); }
  [[nodiscard]] Rank owner(GlobalIndex id) const;
};

/// Moves values between the entities of a rank (by id, in any order) and the block layout.
class BlockRedistribution {
 public:
  BlockRedistribution() = default;
  /// ids: of the entities of this rank; for `to_blocks` each id must be on exactly one rank. Collective.
  BlockRedistribution(const Communicator& ranks, GlobalIndex total, std::span<const GlobalIndex> ids);

  [[nodiscard]] const BlockLayout& layout() const { return layout_; }
  void to_blocks(std::span<const double> held, std::span<double> block, int width) const;
  void from_blocks(std::span<const double> block, std::span<double> held, int width) const;

 private:
  BlockLayout layout_;
  Halo halo_;  // roots: the block of each rank; leaves: the entities held
};

}  // namespace brunt::comm
