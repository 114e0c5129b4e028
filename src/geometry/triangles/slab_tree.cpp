// SPDX-License-Identifier: Apache-2.0
// Construction of the tree: triangles are bisected along the direction with the smallest resulting boxes, in whole
// leaves, until eight groups are children of a node.
#include "geometry/triangles/slab_tree.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pseudo_normals.hpp"
#include "slab_boxes.hpp"
#include "triangle_point.hpp"

namespace brunt::geometry {
namespace {

constexpr double no_lane = -1e300;  ///< half width of a lane without a child: sums of its squares overflow

struct Item {
  Box box;
  LocalIndex triangle = no_index;
};

/// By the middle along an axis; equal ones by the other axes, so that the tree depends on positions, not on numbers.
struct AlongAxis {
  int axis;
  bool operator()(const Item& a, const Item& b) const {
    for (int k = 0; k < 3; ++k) {
      const int c = (axis + k) % 3;
      const double x = a.box.low[c] + a.box.high[c], y = b.box.low[c] + b.box.high[c];
      if (x != y) return x < y;
    }
    return a.triangle < b.triangle;
  }
};

using Items = std::span<Item>;

Box box_of(Items items) {
  Box box;
  for (const Item& item : items) {
    extend(box, item.box.low);
    extend(box, item.box.high);
  }
  return box;
}

double half_area(const Box& box) {
  const Vec3 size = box.high - box.low;
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

/// Moves the first `count` items along the best axis to the front.
void divide(Items items, std::size_t count) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  const auto by = [&](int axis) {
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(count), items.end(), AlongAxis{axis});
  };
  for (int axis = 0; axis < 3; ++axis) {
    by(axis);
    const double areas = half_area(box_of(items.first(count))) + half_area(box_of(items.subspan(count)));
    if (areas < least) {
      least = areas;
      best = axis;
    }
  }
  by(best);
}

/// Divides `items` into groups of `unit` (the last may be smaller).
void group(Items items, std::size_t unit, std::vector<Items>& groups) {
  const std::size_t units = (items.size() + unit - 1) / unit;
  if (units <= 1) {
    groups.push_back(items);
    return;
  }
  const std::size_t count = units / 2 * unit;
  divide(items, count);
  group(items.first(count), unit, groups);
  group(items.subspan(count), unit, groups);
}

class Builder {
 public:
  explicit Builder(SlabTree& tree) : tree_(tree) {}

  LocalIndex add(Items items) {
    const auto index = tree_.nodes.size();
    tree_.nodes.emplace_back();
    tree_.slabs.resize(tree_.slabs.size() + 2 * tree_.directions.size());
    std::size_t unit = 1;
    while (8 * unit < items.size()) unit *= 8;
    std::vector<Items> groups;
    group(items, unit, groups);
    if (unit == 1) tree_.nodes[index].leaf = add_leaf(groups);
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const Items members = lane < groups.size() ? groups[lane] : Items();
      set_box(index, static_cast<int>(lane), members);
      set_slabs(index, static_cast<int>(lane), members);
      LocalIndex child = no_index;
      if (!members.empty()) child = unit == 1 ? members[0].triangle : add(members);
      tree_.nodes[index].child[lane] = child;
    }
    tree_.nodes[index].count = static_cast<std::int32_t>(groups.size());
    return static_cast<LocalIndex>(index);
  }

 private:
  LocalIndex add_leaf(const std::vector<Items>& groups) {
    SlabLeaf& leaf = tree_.leaves.emplace_back();
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const LocalIndex triangle = groups[lane < groups.size() ? lane : 0][0].triangle;
      const Triangle& corners = nth(tree_.triangles, triangle);
      for (std::size_t i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) leaf.corner[i][k][static_cast<int>(lane)] = corners[i][k];
    }
    const auto lanes = [&](std::size_t i) {
      return VecOf<Octet>{leaf.corner[i][0], leaf.corner[i][1], leaf.corner[i][2]};
    };
    const TriangleOf<Octet> all = triangle_of(lanes(0), lanes(1), lanes(2));
    const Octet normal[3] = {all.normal.x, all.normal.y, all.normal.z};
    const Octet inverse2[4] = {all.edge0, all.edge1, all.edge2, all.face};
    std::copy(normal, normal + 3, leaf.normal);
    std::copy(inverse2, inverse2 + 4, leaf.inverse2);
    return static_cast<LocalIndex>(tree_.leaves.size() - 1);
  }

  void set_box(std::size_t index, int lane, Items members) {
    SlabNode& node = tree_.nodes[index];
    const OwnBox box = members.empty() ? OwnBox{Vec3::Zero(), Vec3::Constant(no_lane)} : own_box(box_of(members));
    for (int k = 0; k < 3; ++k) {
      node.middle[k][lane] = box.middle[k];
      node.half[k][lane] = box.half[k] * (members.empty() ? 1.0 : 1 + 0x1p-52);
    }
  }

  void set_slabs(std::size_t index, int lane, Items members) {
    const double rounding = box_rounding * tree_.box.low.cwiseAbs().cwiseMax(tree_.box.high.cwiseAbs()).maxCoeff();
    const std::size_t more = tree_.directions.size();
    for (std::size_t m = 0; m < more; ++m) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Item& item : members)
        for (const Vec3& corner : nth(tree_.triangles, item.triangle)) {
          const double along = corner.dot(tree_.directions[m]);
          low = std::min(low, along);
          high = std::max(high, along);
        }
      Octet* slab = &tree_.slabs[2 * (index * more + m)];
      slab[0][lane] = members.empty() ? 0.0 : 0.5 * (low + high);
      slab[1][lane] = members.empty() ? no_lane : 0.5 * (high - low) + rounding;
    }
  }

  SlabTree& tree_;
};

}  // namespace

std::vector<Vec3> more_directions(int count) {
  if (count != 3 && count != 7 && count != 9 && count != 13)
    throw std::invalid_argument("slab directions: expected 3, 7, 9 or 13");
  std::vector<Vec3> directions;
  if (count == 9 || count == 13) directions = {{0, 1, 1}, {0, 1, -1}, {1, 0, 1}, {-1, 0, 1}, {1, 1, 0}, {1, -1, 0}};
  if (count == 7 || count == 13)
    for (const Vec3& diagonal : {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)})
      directions.push_back(diagonal);
  return directions;
}

SlabTree build_slab_tree(const TriangleSurface& surface, std::span<const Vec3> directions) {
  SlabTree tree;
  for (const Vec3& direction : directions) tree.directions.push_back(direction.normalized());
  std::vector<Item> items;
  items.reserve(surface.triangles.size());
  tree.triangles.reserve(surface.triangles.size());
  tree.leaves.reserve(surface.triangles.size() / 8 + 1);
  for (const auto& corners : surface.triangles) {
    Triangle& triangle = tree.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = nth(surface.points, corners[i]);
    items.push_back({bounding_box(triangle), static_cast<LocalIndex>(items.size())});
  }
  tree.box = box_of(items);
  tree.normals = pseudo_normals(tree.triangles);
  if (!items.empty()) Builder(tree).add(items);
  return tree;
}

}  // namespace brunt::geometry
