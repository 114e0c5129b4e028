// SPDX-License-Identifier: Apache-2.0
// Rows of a sparse matrix of 3 x 3 blocks that are added up one by one.
#pragma once
#include <vector>

#include "brunt/core/types.hpp"

namespace brunt::implicit {

/// One row: a block for each column that something was added to. Blocks of one place are added in the order of the
/// calls. A row meets some dozens of columns, so that a walk through them finds a column faster than a table would.
class BlockRow {
 public:
  void clear();
  void add(GlobalIndex column, const Mat3& block);
  /// Columns ascending. Call once all is added.
  void sort();
  [[nodiscard]] const std::vector<GlobalIndex>& columns() const { return columns_; }
  [[nodiscard]] const Mat3& block(std::size_t k) const { return blocks_[place_[k]]; }  ///< of columns()[k], sorted

 private:
  std::vector<GlobalIndex> columns_;
  std::vector<Mat3> blocks_;
  std::vector<std::uint32_t> place_;
};

using BlockSums = std::vector<BlockRow>;

}  // namespace brunt::implicit
