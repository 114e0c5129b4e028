// SPDX-License-Identifier: Apache-2.0
// Packing of ordered points, and boxes from the bottom up.
#include "brunt/contact/search/point_blocks.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace brunt::contact {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr float no_float = std::numeric_limits<float>::quiet_NaN();

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

void pack_run(const double (&x)[3][block_size], std::size_t run, std::size_t used, const Vec3& origin, Run& packed,
              RunBoxes& boxes) {
  for (int a = 0; a < 3; ++a) {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (std::size_t l = 0; l < run_size; ++l) {
      const auto value = static_cast<float>(x[a][run * run_size + l] - origin[a]);
      packed.x[a][l] = l < used ? value : no_float;
      low = l < used ? std::min(low, value) : low;
      high = l < used ? std::max(high, value) : high;
    }
    boxes.low[a][run] = used > 0 ? low : no_float;
    boxes.high[a][run] = used > 0 ? high : no_float;
  }
}

/// Packs one block and returns its box.
geometry::Box pack_block(std::span<const Vec3> points, std::size_t block, PointBlocks& blocks) {
  const std::size_t first = block * block_size, count = std::min(block_size, blocks.point.size() - first);
  double x[3][block_size];
  geometry::Box box;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& p = points[static_cast<std::size_t>(blocks.point[first + i])];
    for (int a = 0; a < 3; ++a) x[a][i] = p[a];
  }
  for (int a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < count; ++i) {
      box.low[a] = std::min(box.low[a], x[a][i]);
      box.high[a] = std::max(box.high[a], x[a][i]);
    }
    std::fill(x[a] + count, x[a] + block_size, 0.0);
    blocks.origin[block][a] = x[a][count / 2];
  }
  for (std::size_t run = 0; run < runs_of_block; ++run) {
    const std::size_t used = std::min(run_size, count - std::min(count, run * run_size));
    pack_run(x, run, used, blocks.origin[block], blocks.runs[block * runs_of_block + run], blocks.run_boxes[block]);
  }
  return box;
}

std::size_t groups_of(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
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
