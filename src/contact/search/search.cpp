// SPDX-License-Identifier: Apache-2.0
// Search of boxes, sixteen neighbours at a time, through blocks of points.
#include "contact/search/search.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "box_tests.hpp"
#include "core/error.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

static_assert(box_group == 2 * double_lanes);

/// Sixteen boxes that are neighbours, lane by lane; unused lanes hold NaN.
struct Group {
  NodeBoxes half[2];
  Bounds bounds[box_group];
  double low[3], high[3];  ///< box around all

  Group(std::span<const Box> boxes, std::span<const LocalIndex> chosen) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t lane = 0; lane < box_group; ++lane) {
      Octet& of_box = bounds[lane].lanes;
      of_box = Octet{none, none, none, none, none, none, none, none};
      if (lane < chosen.size()) {
        const Box& box = nth(boxes, chosen[lane]);
        for (int a = 0; a < 3; ++a) {
          of_box[a] = box.low[a];
          of_box[a + 3] = box.high[a];
        }
      }
      for (int a = 0; a < 3; ++a) {
        half[lane / double_lanes].low[a][lane % double_lanes] = of_box[a];
        half[lane / double_lanes].high[a][lane % double_lanes] = of_box[a + 3];
      }
    }
    Octet least = bounds[0].lanes, most = least;
    for (std::size_t lane = 1; lane < chosen.size(); ++lane) {
      const Octet& box = bounds[lane].lanes;
      least = least < box ? least : box;
      most = most > box ? most : box;
    }
    for (int a = 0; a < 3; ++a) {
      low[a] = least[a];
      high[a] = most[a + 3];
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

/// The blocks that each box meets, from those that the group meets: row `lane` begins at lane * meetings.size().
void deal_out(SearchScratch& scratch, std::array<std::size_t, box_group>& count) {
  const std::size_t most = scratch.meetings.size();
  if (scratch.blocks_met.size() < most * box_group) scratch.blocks_met.resize(most * box_group);
  count.fill(0);
  for (const Meeting& meeting : scratch.meetings)
    for (LaneMask boxes = meeting.boxes; boxes != 0; boxes = static_cast<LaneMask>(boxes & (boxes - 1))) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(boxes));
      scratch.blocks_met[lane * most + count[lane]++] = meeting.block;
    }
}

void make_room(std::vector<LocalIndex>& list, std::size_t count) {
  if (list.size() >= count) return;
  demand(count < static_cast<std::size_t>(std::numeric_limits<LocalIndex>::max()),
         "contact search: more than 2^31 pairs on one rank");
  list.resize(std::max(count, list.size() + list.size() / 2));
}

/// The runs of some blocks that a box meets. In lists, for a loop over a list is left once, over a mask once a mask.
std::span<const LocalIndex> meet_runs(const Bounds& box, const PointBlocks& blocks, std::span<const LocalIndex> met,
                                      std::vector<LocalIndex>& runs) {
  make_room(runs, (met.size() + 1) * runs_of_block);
  LocalIndex* end = runs.data();
  for (const LocalIndex met_block : met) {
    const auto block = static_cast<std::size_t>(met_block);
    const LaneMask mask = touching(blocks.run_boxes[block], BlockBox(box, blocks.origin[block]));
    end = write_lanes(mask, static_cast<LocalIndex>(block * runs_of_block), end);
  }
  return {runs.data(), end};
}

/// Points that are on the border after rounding: those of them that are in the box.
LaneMask settle(LaneMask ties, std::span<const Vec3> points, const LocalIndex* point, const Box& box) {
  LaneMask inside = 0;
  for (; ties != 0; ties = static_cast<LaneMask>(ties & (ties - 1))) {
    const int lane = std::countr_zero(ties);
    if (geometry::contains(box, nth(points, point[lane]))) inside = static_cast<LaneMask>(inside | 1 << lane);
  }
  return inside;
}

/// Fills `found`, `found_of` and the number of boxes of each place.
class Pass {
 public:
  Pass(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch)
      : boxes_(boxes), points_(points), scratch_(scratch) {}

  std::size_t run() {
    scratch_.found_of.assign(boxes_.size(), {});
    scratch_.met_at.assign(scratch_.blocks.point.size(), 0);
    const std::span<const LocalIndex> order = scratch_.boxes;
    for (std::size_t first = 0; first < order.size(); first += box_group) {
      const std::size_t next = std::min(first + box_group, order.size());
      search_group(order.subspan(first, next - first), order.subspan(next, std::min(box_group, order.size() - next)));
    }
    return total_;
  }

 private:
  /// next: boxes of the group after it, fetched one by one: all at once would fill what can be on its way from memory.
  void search_group(std::span<const LocalIndex> chosen, std::span<const LocalIndex> next) {
    const Group group(boxes_, chosen);
    descend(group, scratch_.blocks, scratch_.meetings);
    std::array<std::size_t, box_group> met_count;
    deal_out(scratch_, met_count);
    for (std::size_t lane = 0; lane < chosen.size(); ++lane) {
      if (lane < next.size()) fetch(static_cast<std::size_t>(next[lane]));
      const std::span met(scratch_.blocks_met.data() + lane * scratch_.meetings.size(), met_count[lane]);
      search_runs(static_cast<std::size_t>(chosen[lane]), group.bounds[lane],
                  meet_runs(group.bounds[lane], scratch_.blocks, met, scratch_.runs_met));
    }
  }

  void fetch(std::size_t b) const {
    __builtin_prefetch(&boxes_[b].low);
    __builtin_prefetch(&boxes_[b].high[2]);
    __builtin_prefetch(&scratch_.found_of[b], 1);
  }

  void search_runs(std::size_t b, const Bounds& bounds, std::span<const LocalIndex> runs) {
    const PointBlocks& blocks = scratch_.blocks;
    make_room(scratch_.found, total_ + (runs.size() + 1) * run_size);
    LocalIndex *const first = scratch_.found.data() + total_, *end = first;
    for (const LocalIndex met_run : runs) {
      const auto run = static_cast<std::size_t>(met_run);
      auto [possible, certain] = holding(BlockBox(bounds, blocks.origin[run / runs_of_block]), blocks.runs[run]);
      if (const auto ties = static_cast<LaneMask>(possible ^ certain); ties != 0) [[unlikely]]
        certain = static_cast<LaneMask>(certain | settle(ties, points_, &blocks.point[run * run_size], boxes_[b]));
      end = write_lanes(certain, static_cast<LocalIndex>(run * run_size), end);
    }
    for (LocalIndex* place = first; place < end; ++place) {
      ++nth(scratch_.met_at, *place);
      *place = nth(blocks.point, *place);
    }
    scratch_.found_of[b] = {static_cast<LocalIndex>(total_), static_cast<LocalIndex>(end - first)};
    total_ += static_cast<std::size_t>(end - first);
  }

  std::span<const Box> boxes_;
  std::span<const Vec3> points_;
  SearchScratch& scratch_;
  std::size_t total_ = 0;
};

/// From boxes with points to points with boxes: boxes are taken in descending order from the ends of rows, so that rows
/// ascend and `offsets` end as the beginnings. Few passes, since points may have any order in memory.
void turn_over(std::size_t point_count, std::size_t total, const SearchScratch& scratch, Ragged<LocalIndex>& pairs) {
  pairs.offsets.assign(point_count + 1, 0);
  const std::vector<LocalIndex>& point = scratch.blocks.point;
  for (std::size_t place = 0; place < point.size(); ++place) nth(pairs.offsets, point[place]) = scratch.met_at[place];
  LocalIndex sum = 0;
  for (LocalIndex& offset : pairs.offsets) offset = sum += offset;
  pairs.values.resize(total);
  for (std::size_t b = scratch.found_of.size(); b-- > 0;) {
    const auto [first, count] = scratch.found_of[b];
    for (LocalIndex k = first; k < first + count; ++k) {
      LocalIndex& end = nth(pairs.offsets, nth(scratch.found, k));
      nth(pairs.values, --end) = static_cast<LocalIndex>(b);
    }
  }
}

}  // namespace

void find_prepared(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch,
                   Ragged<LocalIndex>& pairs) {
  const std::size_t total = Pass(boxes, points, scratch).run();
  turn_over(points.size(), total, scratch, pairs);
}

void find_pairs(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch,
                Ragged<LocalIndex>& pairs) {
  prepare_search(boxes, points, scratch);
  find_prepared(boxes, points, scratch, pairs);
}

}  // namespace brunt::contact
