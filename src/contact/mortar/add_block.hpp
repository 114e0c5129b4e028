// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// Adds a block to the last row, which is still open.
template <class Block>
void add_block(NodeBlocks<Block>& blocks, LocalIndex node, const Block& block) {
  const std::vector<LocalIndex>& nodes = blocks.nodes.values;
  const auto at = std::find(nodes.begin() + blocks.nodes.offsets.back(), nodes.end(), node);
  if (at != nodes.end()) {
    nth(blocks.blocks, at - nodes.begin()) += block;
    return;
  }
  blocks.nodes.values.push_back(node);
  blocks.blocks.push_back(block);
}

/// Adds a matrix times each block of row `row` of another matrix to the last row.
inline void add_row(NodeBlocks<Mat3>& blocks, const Mat3& left, const NodeBlocks<Mat3>& other, LocalIndex row) {
  const std::span<const LocalIndex> nodes = other.nodes.row(row);
  for (std::size_t k = 0; k < nodes.size(); ++k) add_block(blocks, nodes[k], Mat3(left * other.row(row)[k]));
}

/// sum_K w_AK x_K of one row, relative to a point near it to avoid cancellation far from the origin.
inline Vec3 weighted_sum(const NodeBlocks<double>& weights, LocalIndex row, std::span<const Vec3> x) {
  const std::span<const LocalIndex> nodes = weights.nodes.row(row);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < nodes.size(); ++k) sum += weights.row(row)[k] * (nth(x, nodes[k]) - nth(x, nodes[0]));
  return sum;
}

}  // namespace brunt::contact
