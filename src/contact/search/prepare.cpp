// SPDX-License-Identifier: Apache-2.0
// Sorting and packing before a search, from what the last search left where that still serves.
#include <algorithm>
#include <limits>

#include "contact/search/search.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

/// An order is kept while blocks and groups have not grown more than this, on average. Fresh ones are the standard: one
/// that is large because of an outlier hides nothing, one that grows without bound is seen.
constexpr double most_growth = 1.25;

bool holds_something(const Box& box) {
  return (box.low.array() <= box.high.array()).all();
}

Box box_around_all(std::span<const Box> boxes) {
  Box all;
  for (const Box& box : boxes)
    if (holds_something(box)) {
      all.low = all.low.cwiseMin(box.low);
      all.high = all.high.cwiseMax(box.high);
    }
  constexpr double largest = std::numeric_limits<double>::max();
  all.low = all.low.cwiseMax(-largest);
  all.high = all.high.cwiseMin(largest);
  return all;
}

enum class Reach : char { never, far, near };

/// Chooses what is to be ordered: what is near, or where most is near all that may ever be, so that little changes from
/// one search to the next. True if it is other than before.
template <class ReachOf>
bool choose(std::size_t count, const ReachOf& reach_of, SearchHistory::Choice& choice) {
  choice.reach.resize(count);
  std::size_t near = 0, far = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Reach reach = reach_of(i);
    choice.reach[i] = static_cast<char>(reach);
    near += reach == Reach::near ? 1 : 0;
    far += reach == Reach::far ? 1 : 0;
  }
  const auto least = static_cast<char>(far <= near ? Reach::far : Reach::near);
  bool changed = choice.chosen.size() != count;
  choice.chosen.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const char chosen = choice.reach[i] >= least ? 1 : 0;
    changed |= choice.chosen[i] != chosen;
    choice.chosen[i] = chosen;
  }
  return changed;
}

void list_chosen(const SearchHistory::Choice& choice, std::vector<LocalIndex>& list) {
  list.resize(choice.chosen.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < choice.chosen.size(); ++i)
    if (choice.chosen[i] != 0) list[count++] = static_cast<LocalIndex>(i);
  list.resize(count);
}

float extent_of(const Box& box) {
  return static_cast<float>((box.high - box.low).sum());
}

Box box_of_block(const PointBlocks& blocks, std::size_t block) {
  const NodeBoxes& node = blocks.levels[0][block / branches];
  Box box;
  for (int a = 0; a < 3; ++a) {
    box.low[a] = node.low[a][block % branches];
    box.high[a] = node.high[a][block % branches];
  }
  return box;
}

/// Around a group, of what it has in common with the region.
Box box_of_group(std::span<const Box> boxes, const Box& region, std::span<const LocalIndex> order, std::size_t group) {
  Box around;
  const std::size_t end = std::min(order.size(), (group + 1) * box_group);
  for (std::size_t k = group * box_group; k < end; ++k) {
    const Box& ahead = nth(boxes, order[std::min(k + 2 * box_group, order.size() - 1)]);
    __builtin_prefetch(&ahead.low);
    __builtin_prefetch(&ahead.high[2]);
    const Box& box = nth(boxes, order[k]);
    around.low = around.low.cwiseMin(box.low);
    around.high = around.high.cwiseMax(box.high);
  }
  return {around.low.cwiseMax(region.low), around.high.cwiseMin(region.high)};
}

/// Are boxes 0, 1, ... larger, on average, than an order is kept for?
template <class BoxOf>
bool have_grown(const BoxOf& box_of, std::span<const float> fresh) {
  double growth = 0;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const float now = extent_of(box_of(i));
    growth += now <= fresh[i] ? 1.0 : double{now} / double{fresh[i]};
  }
  return !(growth <= most_growth * static_cast<double>(fresh.size()));
}

template <class BoxOf>
void keep_extents(const BoxOf& box_of, std::size_t count, std::vector<float>& extents) {
  extents.resize(count);
  for (std::size_t i = 0; i < count; ++i) extents[i] = extent_of(box_of(i));
}

void order_points(std::span<const Vec3> points, bool changed, SearchScratch& scratch) {
  std::vector<float>& extents = scratch.history.block_extents;
  const auto box_of = [&](std::size_t block) { return box_of_block(scratch.blocks, block); };
  if (!changed) {
    build_blocks(points, scratch.blocks);
    if (!have_grown(box_of, extents)) return;
  }
  list_chosen(scratch.history.points, scratch.blocks.point);
  order_in_space(points, scratch.blocks.point, scratch.sort);
  build_blocks(points, scratch.blocks);
  keep_extents(box_of, scratch.blocks.block_count(), extents);
}

void order_boxes(std::span<const Box> boxes, const Box& region, bool changed, SearchScratch& scratch) {
  std::vector<float>& extents = scratch.history.group_extents;
  const auto box_of = [&](std::size_t group) { return box_of_group(boxes, region, scratch.boxes, group); };
  if (!changed && !have_grown(box_of, extents)) return;
  list_chosen(scratch.history.boxes, scratch.boxes);
  order_in_space(boxes, region, scratch.boxes, scratch.sort);
  keep_extents(box_of, (scratch.boxes.size() + box_group - 1) / box_group, extents);
}

}  // namespace

void prepare_search(std::span<const Box> boxes, std::span<const Vec3> points, SearchScratch& scratch) {
  const Box all_boxes = box_around_all(boxes);
  Box region;  // of the points that may pair
  const bool other_points = choose(
      points.size(),
      [&](std::size_t p) {
        if (!geometry::contains(all_boxes, points[p])) return points[p].allFinite() ? Reach::far : Reach::never;
        geometry::extend(region, points[p]);
        return Reach::near;
      },
      scratch.history.points);
  const bool any_points = holds_something(region);
  const bool other_boxes = choose(
      boxes.size(),
      [&](std::size_t b) {
        if (!any_points || !holds_something(boxes[b])) return Reach::never;
        return geometry::overlaps(boxes[b], region) ? Reach::near : Reach::far;
      },
      scratch.history.boxes);
  order_points(points, other_points, scratch);
  order_boxes(boxes, region, other_boxes, scratch);
}

std::size_t SearchScratch::memory_bytes() const {
  const auto bytes = [](const auto&... vectors) { return (0 + ... + (vectors.capacity() * sizeof(vectors[0]))); };
  std::size_t total =
      bytes(sort.items, sort.other, sort.digits, boxes, meetings, blocks_met, runs_met, found, found_of, met_at,
            blocks.point, blocks.runs, blocks.run_boxes, blocks.origin, history.points.reach, history.points.chosen,
            history.boxes.reach, history.boxes.chosen, history.block_extents, history.group_extents);
  for (const auto& level : blocks.levels) total += bytes(level);
  return total;
}

}  // namespace brunt::contact
