// SPDX-License-Identifier: Apache-2.0
// Orders points or boxes so that neighbours in the order are neighbours in space.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::contact {

/// Work arrays of the sort, kept so that sorting again allocates nothing.
struct SortScratch {
  std::vector<std::uint64_t> items, other;  ///< key above, index below
  std::vector<LocalIndex> digits;           ///< histograms of the radix sort
};

/// Reorders `order` (indices into `points`, whose coordinates are finite) along the Hilbert curve of cubic cells over
/// their bounding box. Points in crowded cells are ordered again by smaller cells of the same curve, and so on: far
/// outliers, graded sizes and planes cost another pass over the crowded cells, but do not change the order. O(n) for
/// each pass.
void order_in_space(std::span<const Vec3> points, std::vector<LocalIndex>& order, SortScratch& scratch);

/// The same for boxes, each by the centre of its intersection with `region`, which must be finite.
void order_in_space(std::span<const geometry::Box> boxes, const geometry::Box& region, std::vector<LocalIndex>& order,
                    SortScratch& scratch);

}  // namespace brunt::contact
