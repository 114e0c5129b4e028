// SPDX-License-Identifier: Apache-2.0
// Search on one rank: the points in each box. No physics, no messages.
#pragma once
#include <span>
#include <vector>

#include "contact/search/point_blocks.hpp"
#include "contact/search/spatial_order.hpp"
#include "core/ragged.hpp"
#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::contact {

constexpr std::size_t box_group = 16;  ///< boxes that are searched together

/// Data for the next search of the same points and boxes after some motion: the order, which is reused as long as it
/// contains the same points and its blocks of points and groups of boxes remain small.
struct SearchHistory {
  struct Choice {
    std::vector<char> reach;   ///< whether each may pair, and if not whether it may after some motion
    std::vector<char> chosen;  ///< whether the order holds it
  };
  Choice points, boxes;
  std::vector<float> block_extents, group_extents;  ///< when they were sorted [length]
};

/// Work arrays of a search. Reuse avoids all allocation and most of the sorting. Results do not depend on it.
struct SearchScratch {
  struct Segment {
    LocalIndex first = 0, count = 0;
  };
  /// A block of points and those boxes of a group of sixteen that touch it.
  struct Meeting {
    LocalIndex block = 0;
    LaneMask boxes = 0;
  };
  SearchHistory history;
  SortScratch sort;
  PointBlocks blocks;
  std::vector<LocalIndex> boxes;  ///< in spatial order
  std::vector<Meeting> meetings;
  std::vector<LocalIndex> blocks_met;  ///< by each box of a group
  std::vector<LocalIndex> runs_met;    ///< by one box
  std::vector<LocalIndex> found;       ///< points, box after box
  std::vector<Segment> found_of;       ///< box -> its part of `found`
  std::vector<LocalIndex> met_at;      ///< of a place: its number of boxes

  [[nodiscard]] std::size_t memory_bytes() const;
};

/// pairs row p: the boxes that contain point p, ascending; boxes are closed. Points with a coordinate that is not
/// finite are in no box; a box with low > high or a NaN contains nothing, and bounds may be infinite.
///
/// Points are stored in blocks along a space-filling curve (spatial_order.hpp), sixteen runs of sixteen points, below a
/// tree of boxes. Sixteen boxes at a time along the same curve descend the tree together to a common list of blocks,
/// where each box is tested against sixteen runs and then sixteen points at once. This replaces the bisection of sorted
/// lists of Heinstein et al. 2000, section 4.4: the curve is the sort, a run is the short list. Work O(n log n) with a
/// small logarithmic part, memory linear; nothing depends on a cell size.
void find_pairs(std::span<const geometry::Box> boxes, std::span<const Vec3> points, SearchScratch& scratch,
                Ragged<LocalIndex>& pairs);

/// The two parts of find_pairs, for timing: sorting and packing, then the search with the same arguments.
void prepare_search(std::span<const geometry::Box> boxes, std::span<const Vec3> points, SearchScratch& scratch);
void find_prepared(std::span<const geometry::Box> boxes, std::span<const Vec3> points, SearchScratch& scratch,
                   Ragged<LocalIndex>& pairs);

}  // namespace brunt::contact
