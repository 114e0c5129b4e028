// SPDX-License-Identifier: Apache-2.0
// An order of points or boxes in which neighbours in the order are neighbours in space.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/core/types.hpp"
#include "brunt/geometry/box.hpp"

namespace brunt::contact {

/// Work arrays of the sort, kept so that sorting again allocates nothing.
struct SortScratch {
  std::vector<std::uint64_t> items, other;  ///< key above, index below
  std::vector<LocalIndex> digits;           ///< histograms of the radix sort
};

/// Reorders `order` (indices into `points`, whose coordinates are finite) along the Hilbert curve of cubic cells over
/// their bounding box. What shares a cell with many others is ordered again by smaller cells of the same curve, and so
/// on: far outliers, graded sizes and planes cost another pass over the crowded cells, never the order. O(n) a pass.
void order_in_space(std::span<const Vec3> points, std::vector<LocalIndex>& order, SortScratch& scratch);

/// The same for boxes, each by the centre of what it has in common with `region`, which must be something finite.
void order_in_space(std::span<const geometry::Box> boxes, const geometry::Box& region, std::vector<LocalIndex>& order,
                    SortScratch& scratch);

}  // namespace brunt::contact
