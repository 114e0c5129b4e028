// SPDX-License-Identifier: Apache-2.0
#include "implicit/mortar/block_sums.hpp"

#include <algorithm>
#include <numeric>

namespace brunt::implicit {

void BlockRow::clear() {
  columns_.clear();
  blocks_.clear();
}

void BlockRow::add(GlobalIndex column, const Mat3& block) {
  const auto at = std::ranges::find(columns_, column);
  if (at != columns_.end()) {
    nth(blocks_, at - columns_.begin()) += block;
    return;
  }
  columns_.push_back(column);
  blocks_.emplace_back(block);
}

void BlockRow::sort() {
  place_.resize(columns_.size());
  std::iota(place_.begin(), place_.end(), 0U);
  std::ranges::sort(place_, {}, [this](std::uint32_t k) { return columns_[k]; });
  std::ranges::sort(columns_);
}

}  // namespace brunt::implicit
