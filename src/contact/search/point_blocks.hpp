// SPDX-License-Identifier: Apache-2.0
// Points in blocks of neighbours below a tree of boxes: the data structure of the search.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "contact/search/lanes.hpp"
#include "core/aligned.hpp"
#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::contact {

constexpr std::size_t run_size = float_lanes;                 ///< points that are tested at once
constexpr std::size_t runs_of_block = float_lanes;            ///< runs whose boxes are tested at once
constexpr std::size_t block_size = run_size * runs_of_block;  ///< points
constexpr std::size_t branches = double_lanes;                ///< boxes of a tree node, tested at once

/// Eight boxes of a tree node. Unused lanes are NaN, which overlaps nothing.
struct alignas(64) NodeBoxes {
  double low[3][branches], high[3][branches];
};

/// Sixteen boxes of the runs of a block, relative to the block's origin.
struct alignas(64) RunBoxes {
  float low[3][runs_of_block], high[3][runs_of_block];
};

/// Sixteen neighbouring points relative to the block's origin. Unused lanes are NaN.
struct alignas(64) Run {
  float x[3][run_size];
};

/// Origin of a block, x y z x y z 0 0, which is subtracted from both bounds of a box.
struct BlockOrigin {
  Octet twice;
};

/// Coordinates inside a block are rounded to float after subtracting the block's origin. Both operations are monotone,
/// and the bounds of boxes undergo the same: a point in a box is never lost, and a point strictly inside after rounding
/// is inside. Only ties need the original coordinates.
struct PointBlocks {
  std::vector<LocalIndex> point;      ///< place in the order -> index of the point
  AlignedVector<Run> runs;            ///< of place / 16; whole blocks
  AlignedVector<RunBoxes> run_boxes;  ///< of a block
  AlignedVector<BlockOrigin> origin;  ///< of a block: one of its points
  /// levels[0][k] holds the boxes of blocks 8k..8k+7, levels[l][k] those of nodes 8k..8k+7 of levels[l-1]; the highest
  /// level that is used has one node.
  std::array<AlignedVector<NodeBoxes>, 12> levels;
  std::size_t level_count = 0;

  [[nodiscard]] std::size_t block_count() const { return origin.size(); }
};

/// Fills all members except `point`, the order, which is given. Coordinates must be finite.
void build_blocks(std::span<const Vec3> points, PointBlocks& blocks);

}  // namespace brunt::contact
