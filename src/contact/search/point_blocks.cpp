// SPDX-License-Identifier: Apache-2.0
// Packing of ordered points, and boxes from the bottom up.
#include "contact/search/point_blocks.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace brunt::contact {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr float no_float = std::numeric_limits<float>::quiet_NaN();

std::size_t groups_of(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
}

void set_box(NodeBoxes& node, std::size_t lane, const geometry::Box& box) {
  for (int a = 0; a < 3; ++a) {
    node.low[a][lane] = box.low[a];
    node.high[a][lane] = box.high[a];
  }
}

/// Unused lanes come last, and a NaN is neither less nor greater.
geometry::Box box_of(const NodeBoxes& node) {
  geometry::Box box;
  for (int a = 0; a < 3; ++a) {
    box.low[a] = *std::min_element(node.low[a], node.low[a] + branches);
    box.high[a] = *std::max_element(node.high[a], node.high[a] + branches);
  }
  return box;
}

/// The least or greatest of 2^k values, by halves: unlike a running minimum that takes k steps and not 2^k.
template <class T, std::size_t N, class Better>
T best_of(const T* values, const Better& better) {
  T best[N / 2];
  for (std::size_t l = 0; l < N / 2; ++l) best[l] = better(values[l], values[l + N / 2]);
  if constexpr (N == 2) {
    return best[0];
  } else {
    return best_of<T, N / 2>(best, better);
  }
}

constexpr auto lesser = [](auto a, auto b) { return b < a ? b : a; };
constexpr auto greater = [](auto a, auto b) { return a < b ? b : a; };

/// Coordinates of a block along one axis; places after the last point repeat it.
struct BlockAxis {
  alignas(64) double x[block_size];
  alignas(64) float local[block_size];
};

void pack_axis(BlockAxis& axis, int a, double origin, std::size_t used, Run* runs, RunBoxes& boxes) {
  for (std::size_t i = 0; i < block_size; ++i) axis.local[i] = static_cast<float>(axis.x[i] - origin);
  for (std::size_t run = 0; run < runs_of_block; ++run) {
    const float* x = axis.local + run * run_size;
    std::copy_n(x, run_size, runs[run].x[a]);
    boxes.low[a][run] = best_of<float, run_size>(x, lesser);
    boxes.high[a][run] = best_of<float, run_size>(x, greater);
  }
  for (std::size_t i = used; i < block_size; ++i) runs[i / run_size].x[a][i % run_size] = no_float;
  for (std::size_t run = groups_of(used, run_size); run < runs_of_block; ++run)
    boxes.low[a][run] = boxes.high[a][run] = no_float;
}

/// Packs one block and returns its box.
geometry::Box pack_block(std::span<const Vec3> points, std::size_t block, PointBlocks& blocks) {
  const std::size_t first = block * block_size, used = std::min(block_size, blocks.point.size() - first);
  BlockAxis axes[3];
  for (std::size_t i = 0; i < block_size; ++i) {
    const std::size_t place = first + std::min(i, used - 1);
    const std::size_t ahead = std::min(place + 64, blocks.point.size() - 1);
    const Vec3& later = nth(points, blocks.point[ahead]);
    __builtin_prefetch(&later[0]);
    __builtin_prefetch(&later[2]);
    const Vec3& point = nth(points, blocks.point[place]);
    for (int a = 0; a < 3; ++a) axes[a].x[i] = point[a];
  }
  geometry::Box box;
  for (int a = 0; a < 3; ++a) {
    box.low[a] = best_of<double, block_size>(axes[a].x, lesser);
    box.high[a] = best_of<double, block_size>(axes[a].x, greater);
    const double origin = axes[a].x[used / 2];
    blocks.origin[block].twice[a] = blocks.origin[block].twice[a + 3] = origin;
    pack_axis(axes[a], a, origin, used, &blocks.runs[block * runs_of_block], blocks.run_boxes[block]);
  }
  return box;
}

/// One level of the tree: nodes over `count` boxes, box_of(i) the i-th.
template <class BoxOf>
void build_level(std::size_t count, const BoxOf& box_of, AlignedVector<NodeBoxes>& nodes) {
  nodes.resize(groups_of(count, branches));
  for (auto& bounds : {std::ref(nodes.back().low), std::ref(nodes.back().high)})
    for (auto& axis : bounds.get()) std::fill_n(axis, branches, no_number);
  for (std::size_t i = 0; i < count; ++i) set_box(nodes[i / branches], i % branches, box_of(i));
}

}  // namespace

void build_blocks(std::span<const Vec3> points, PointBlocks& blocks) {
  const std::size_t block_count = groups_of(blocks.point.size(), block_size);
  blocks.runs.resize(block_count * runs_of_block);
  blocks.run_boxes.resize(block_count);
  blocks.origin.resize(block_count);
  blocks.level_count = 0;
  if (block_count == 0) return;
  build_level(
      block_count, [&](std::size_t block) { return pack_block(points, block, blocks); }, blocks.levels[0]);
  for (blocks.level_count = 1; blocks.levels[blocks.level_count - 1].size() > 1; ++blocks.level_count) {
    const AlignedVector<NodeBoxes>& below = blocks.levels[blocks.level_count - 1];
    build_level(
        below.size(), [&](std::size_t node) { return box_of(below[node]); }, blocks.levels[blocks.level_count]);
  }
}

}  // namespace brunt::contact
