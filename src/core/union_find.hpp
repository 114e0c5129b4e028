// SPDX-License-Identifier: Apache-2.0
// Members that are joined to sets, each known by its least member, so that the sets do not depend on the order of
// joins.
#pragma once
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace brunt {

class UnionFind {
 public:
  explicit UnionFind(std::size_t members = 0) { reset(members); }

  /// Members 0 ... members - 1, none joined.
  void reset(std::size_t members) {
    above_.resize(members);
    std::iota(above_.begin(), above_.end(), LocalIndex{0});
  }
  void reserve(std::size_t members) { above_.reserve(members); }
  [[nodiscard]] std::size_t size() const { return above_.size(); }

  /// The least member of the set. Ways to it become shorter.
  [[nodiscard]] std::size_t first(std::size_t member) {
    while (above(member) != member) {
      above_[member] = above_[above(member)];
      member = above(member);
    }
    return member;
  }
  void join(std::size_t one, std::size_t other) {
    const auto [low, high] = std::minmax({first(one), first(other)});
    above_[high] = static_cast<LocalIndex>(low);
  }

 private:
  [[nodiscard]] std::size_t above(std::size_t member) const { return static_cast<std::size_t>(above_[member]); }

  std::vector<LocalIndex> above_;
};

}  // namespace brunt
