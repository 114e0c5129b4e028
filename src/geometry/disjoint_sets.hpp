// SPDX-License-Identifier: Apache-2.0
// Disjoint sets of n items, joined pair by pair.
#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

#include "core/types.hpp"

namespace brunt::geometry {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The least item of the set.
  [[nodiscard]] LocalIndex find(LocalIndex item) {
    while (parent(item) != item) item = parent(item) = parent(parent(item));
    return item;
  }

  void join(LocalIndex a, LocalIndex b) {
    a = find(a);
    b = find(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  LocalIndex& parent(LocalIndex item) { return parent_[static_cast<std::size_t>(item)]; }
  std::vector<LocalIndex> parent_;
};

}  // namespace brunt::geometry
