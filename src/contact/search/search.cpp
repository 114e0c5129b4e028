// SPDX-License-Identifier: Apache-2.0
// Search of boxes, sixteen neighbours at a time, through blocks of points.
#include "brunt/contact/search/search.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "box_tests.hpp"
#include "brunt/core/error.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

constexpr std::size_t group_size = 2 * double_lanes;

bool holds_something(const Box& box) {
  return (box.low.array() <= box.high.array()).all();
}

/// Lists the points and boxes that may pair, and returns a box around those points.
Box choose_near(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch) {
  Box all_boxes, near_points;
  for (const Box& box : boxes)
    if (holds_something(box)) {
      all_boxes.low = all_boxes.low.cwiseMin(box.low);
      all_boxes.high = all_boxes.high.cwiseMax(box.high);
    }
  constexpr double largest = std::numeric_limits<double>::max();
  all_boxes.low = all_boxes.low.cwiseMax(-largest);
  all_boxes.high = all_boxes.high.cwiseMin(largest);
  std::vector<LocalIndex>& point_list = scratch.blocks.point;
  point_list.resize(points.size());
  std::size_t count = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (!geometry::contains(all_boxes, points[p])) continue;
    geometry::extend(near_points, points[p]);
    point_list[count++] = static_cast<LocalIndex>(p);
  }
  point_list.resize(count);
  scratch.boxes.resize(boxes.size());
  count = 0;
  for (std::size_t b = 0; b < boxes.size(); ++b)
    if (!point_list.empty() && holds_something(boxes[b]) && geometry::overlaps(boxes[b], near_points))
      scratch.boxes[count++] = static_cast<LocalIndex>(b);
  scratch.boxes.resize(count);
  return near_points;
}

/// Sixteen boxes that are neighbours, lane by lane; unused lanes hold NaN.
struct Group {
  NodeBoxes half[2];
  double low[3], high[3];  ///< box around all

  Group(std::span<const Box> boxes, std::span<const LocalIndex> chosen) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (int a = 0; a < 3; ++a) {
      low[a] = std::numeric_limits<double>::infinity();
      high[a] = -low[a];
    }
    for (std::size_t lane = 0; lane < group_size; ++lane) {
      NodeBoxes& lanes = half[lane / double_lanes];
      const bool used = lane < chosen.size();
      const Box* box = used ? &boxes[static_cast<std::size_t>(chosen[lane])] : nullptr;
      for (int a = 0; a < 3; ++a) {
        lanes.low[a][lane % double_lanes] = used ? box->low[a] : none;
        lanes.high[a][lane % double_lanes] = used ? box->high[a] : none;
        if (!used) continue;
        low[a] = std::min(low[a], box->low[a]);
        high[a] = std::max(high[a], box->high[a]);
      }
    }
  }

  /// Boxes of the group that touch child `lane` of `node`.
  [[nodiscard]] LaneMask touching_child(const NodeBoxes& node, int lane) const {
    const double child_low[3]{node.low[0][lane], node.low[1][lane], node.low[2][lane]};
    const double child_high[3]{node.high[0][lane], node.high[1][lane], node.high[2][lane]};
    return static_cast<LaneMask>(touching(half[0], child_low, child_high) | touching(half[1], child_low, child_high)
                                                                                << double_lanes);
  }
};

using Meeting = SearchScratch::Meeting;

/// The blocks that boxes of the group touch. A large box among small ones or far from them costs no more than alone.
void descend(const Group& group, const PointBlocks& blocks, std::vector<Meeting>& meetings) {
  struct Visit {
    std::size_t level, node;
  };
  std::array<Visit, 12 * branches> open;
  std::size_t count = 0;
  meetings.clear();
  open[count++] = {blocks.level_count - 1, 0};
  while (count > 0) {
    const auto [level, n] = open[--count];
    const NodeBoxes& node = blocks.levels[level][n];
    for (LaneMask mask = touching(node, group.low, group.high); mask != 0;
         mask = static_cast<LaneMask>(mask & (mask - 1))) {
      const int lane = std::countr_zero(mask);
      const LaneMask boxes = group.touching_child(node, lane);
      if (boxes == 0) continue;
      const std::size_t child = n * branches + static_cast<std::size_t>(lane);
      if (level == 0) {
        meetings.push_back({static_cast<LocalIndex>(child), boxes});
      } else {
        open[count++] = {level - 1, child};
      }
    }
  }
}

/// Appends the places of the block's points in the box; room for a block and a run must be there.
LocalIndex* search_block(std::span<const Vec3> points, const PointBlocks& blocks, std::size_t block, const Box& box,
                         LocalIndex* found) {
  const BlockBox local(box, blocks.origin[block]);
  for (LaneMask runs = touching(blocks.run_boxes[block], local); runs != 0;
       runs = static_cast<LaneMask>(runs & (runs - 1))) {
    const std::size_t run = block * runs_of_block + static_cast<std::size_t>(std::countr_zero(runs));
    auto [possible, certain] = holding(local, blocks.runs[run]);
    for (auto ties = static_cast<LaneMask>(possible ^ certain); ties != 0;
         ties = static_cast<LaneMask>(ties & (ties - 1))) {
      const int lane = std::countr_zero(ties);
      const LocalIndex point = blocks.point[run * run_size + static_cast<std::size_t>(lane)];
      if (geometry::contains(box, points[static_cast<std::size_t>(point)]))
        certain = static_cast<LaneMask>(certain | 1 << lane);
    }
    found = write_lanes(certain, static_cast<LocalIndex>(run * run_size), found);
  }
  return found;
}

void make_room(std::vector<LocalIndex>& found, std::size_t count) {
  demand(count < static_cast<std::size_t>(std::numeric_limits<LocalIndex>::max()),
         "contact search: more than 2^31 pairs on one rank");
  if (found.size() < count) found.resize(std::max(count, found.size() + found.size() / 2));
}

/// Fills `found`, `found_of` and the number of boxes of each place.
std::size_t search_all(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch) {
  const PointBlocks& blocks = scratch.blocks;
  scratch.found_of.assign(boxes.size(), {});
  scratch.cursor.assign(blocks.point.size(), 0);
  std::size_t total = 0;
  for (std::size_t first = 0; first < scratch.boxes.size(); first += group_size) {
    const std::span<const LocalIndex> chosen =
        std::span(scratch.boxes).subspan(first, std::min(group_size, scratch.boxes.size() - first));
    descend(Group(boxes, chosen), blocks, scratch.meetings);
    for (std::size_t lane = 0; lane < chosen.size(); ++lane) {
      const auto b = static_cast<std::size_t>(chosen[lane]);
      const std::size_t before = total;
      for (const Meeting& meeting : scratch.meetings) {
        if ((meeting.boxes >> lane & 1) == 0) continue;
        make_room(scratch.found, total + block_size + run_size);
        LocalIndex* to = scratch.found.data() + total;
        total += static_cast<std::size_t>(
            search_block(points, blocks, static_cast<std::size_t>(meeting.block), boxes[b], to) - to);
      }
      scratch.found_of[b] = {static_cast<LocalIndex>(before), static_cast<LocalIndex>(total - before)};
      for (std::size_t k = before; k < total; ++k) ++scratch.cursor[static_cast<std::size_t>(scratch.found[k])];
    }
  }
  return total;
}

/// From boxes with places of points to points with boxes: boxes come in ascending order, so rows do too.
void turn_over(std::size_t point_count, std::size_t total, SearchScratch& scratch, Ragged<LocalIndex>& pairs) {
  pairs.offsets.assign(point_count + 1, 0);
  const std::vector<LocalIndex>& point = scratch.blocks.point;
  for (std::size_t place = 0; place < point.size(); ++place)
    pairs.offsets[static_cast<std::size_t>(point[place]) + 1] = scratch.cursor[place];
  for (std::size_t p = 0; p < point_count; ++p) pairs.offsets[p + 1] += pairs.offsets[p];
  for (std::size_t place = 0; place < point.size(); ++place)
    scratch.cursor[place] = pairs.offsets[static_cast<std::size_t>(point[place])];
  pairs.values.resize(total);
  for (std::size_t b = 0; b < scratch.found_of.size(); ++b) {
    const auto [first, count] = scratch.found_of[b];
    for (LocalIndex k = first; k < first + count; ++k) {
      const auto place = static_cast<std::size_t>(scratch.found[static_cast<std::size_t>(k)]);
      pairs.values[static_cast<std::size_t>(scratch.cursor[place]++)] = static_cast<LocalIndex>(b);
    }
  }
}

}  // namespace

void prepare_search(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch) {
  const Box region = choose_near(boxes, points, scratch);
  order_in_space(points, scratch.blocks.point, scratch.sort);
  order_in_space(boxes, region, scratch.boxes, scratch.sort);
  build_blocks(points, scratch.blocks);
}

void find_prepared(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch,
                   Ragged<LocalIndex>& pairs) {
  const std::size_t total = search_all(boxes, points, scratch);
  turn_over(points.size(), total, scratch, pairs);
}

void find_pairs(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch,
                Ragged<LocalIndex>& pairs) {
  prepare_search(boxes, points, scratch);
  find_prepared(boxes, points, scratch, pairs);
}

std::size_t SearchScratch::memory_bytes() const {
  const auto bytes = [](const auto&... vectors) { return (0 + ... + (vectors.capacity() * sizeof(vectors[0]))); };
  std::size_t total = bytes(sort.items, sort.other, sort.digits, boxes, meetings, found, found_of, cursor, blocks.point,
                            blocks.runs, blocks.run_boxes, blocks.origin);
  for (const auto& level : blocks.levels) total += bytes(level);
  return total;
}

}  // namespace brunt::contact
