// SPDX-License-Identifier: Apache-2.0
// Rows of a sparse matrix of 3 x 3 blocks, assembled from single terms.
#pragma once
#include <vector>

#include "core/types.hpp"

namespace brunt::implicit {

/// One row: a block for each column with a term. Blocks of one entry are added in the order of the calls. A row has
/// some dozens of columns, for which a linear search is faster than a hash table.
class BlockRow {
 public:
  void clear();
  void add(GlobalIndex column, const Mat3& block);
  /// Columns ascending. To be called after the last term.
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
