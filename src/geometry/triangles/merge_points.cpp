// SPDX-License-Identifier: Apache-2.0
// Equal points by sorting, near ones by a grid (see the header).
#include "geometry/triangles/merge_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/union_find.hpp"

namespace brunt::geometry {
namespace {

std::size_t at(LocalIndex i) {
  return static_cast<std::size_t>(i);
}

bool before(const Vec3& a, const Vec3& b) {
  return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
}

struct Extent {
  Vec3 low = Vec3::Zero();
  double diagonal = 0, largest = 0;  ///< largest: magnitude of a coordinate
};

Extent extent_of(const std::vector<Vec3>& points) {
  Extent extent;
  if (points.empty()) return extent;
  Vec3 low = points[0], high = points[0];
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  extent.low = low;
  extent.diagonal = (high - low).norm();
  extent.largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  return extent;
}

/// Equal points as one, in ascending order of their coordinates.
struct Distinct {
  std::vector<Vec3> points;
  std::vector<LocalIndex> of_point;  ///< position in points, of each point of the surface
};

Distinct distinct_points(const std::vector<Vec3>& points) {
  std::vector<LocalIndex> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](LocalIndex a, LocalIndex b) { return before(points[at(a)], points[at(b)]); });
  Distinct distinct;
  distinct.of_point.resize(points.size());
  for (const LocalIndex i : order) {
    if (distinct.points.empty() || before(distinct.points.back(), points[at(i)]))
      distinct.points.emplace_back(points[at(i)].array() + 0.);  // -0 becomes 0
    distinct.of_point[at(i)] = static_cast<LocalIndex>(distinct.points.size()) - 1;
  }
  return distinct;
}

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t k : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15U;  // 2^64 over the golden ratio
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

/// Cubes of four tolerances: the neighbours of most points lie in the same one.
class Grid {
 public:
  Grid(const std::vector<Vec3>& points, const Vec3& origin, double tolerance)
      : points_(points), origin_(origin), tolerance_(tolerance), sets_(points.size()), next_(points.size(), no_index) {
    cells_.reserve(points.size());
  }

  /// Joins each point with previous ones; cells are filled in the same pass.
  UnionFind join() {
    for (LocalIndex i = 0; i < static_cast<LocalIndex>(points_.size()); ++i) {
      const Vec3& x = points_[at(i)];
      const Cell low = cell_of(x.array() - tolerance_), high = cell_of(x.array() + tolerance_);
      Cell cell;
      for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
        for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
          for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
            if (const auto found = cells_.find(cell); found != cells_.end()) join_near(i, found->second);
      add(i, cells_[cell_of(x)]);
    }
    return std::move(sets_);
  }

 private:
  struct Members {
    LocalIndex last = no_index;  // the others are linked by next_
    std::size_t count = 0;
  };

  [[nodiscard]] Cell cell_of(const Vec3& x) const {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
      nth(cell, axis) = static_cast<std::int64_t>(std::floor((x[axis] - origin_[axis]) / (4 * tolerance_)));
    return cell;
  }

  void join_near(LocalIndex i, const Members& members) {
    for (LocalIndex other = members.last; other != no_index; other = next_[at(other)])
      if ((points_[at(other)] - points_[at(i)]).squaredNorm() <= tolerance_ * tolerance_) sets_.join(at(i), at(other));
  }

  void add(LocalIndex i, Members& members) {
    if (members.count < crowded_cell) {
      next_[at(i)] = std::exchange(members.last, i);
      ++members.count;
      return;
    }
    for (LocalIndex other = members.last; members.count == crowded_cell && other != no_index; other = next_[at(other)])
      sets_.join(at(members.last), at(other));
    members.count = crowded_cell + 1;
    sets_.join(at(members.last), at(i));
  }

  const std::vector<Vec3>& points_;
  Vec3 origin_;
  double tolerance_;
  UnionFind sets_;
  std::vector<LocalIndex> next_;  // in the same cell
  std::unordered_map<Cell, Members, CellHash> cells_;
};

UnionFind groups_of(const std::vector<Vec3>& points, double tolerance) {
  const Extent extent = extent_of(points);
  if (tolerance < std::ldexp(extent.diagonal, -50) || tolerance == 0) return UnionFind(points.size());
  return Grid(points, extent.low, tolerance).join();
}

}  // namespace

double default_tolerance(const TriangleSurface& surface, bool single_precision) {
  const Extent extent = extent_of(surface.points);
  const double ratio = single_precision ? merge_ratio_single : merge_ratio_double;
  const double unit = std::ldexp(extent.largest, single_precision ? -24 : -53);
  return std::max(ratio * extent.diagonal, merge_rounding * unit);
}

MergedSurface merge_points(const TriangleSurface& surface, double tolerance) {
  demand(tolerance >= 0, "a tolerance of merging is not negative");
  const Distinct distinct = distinct_points(surface.points);
  UnionFind groups = groups_of(distinct.points, tolerance);
  MergedSurface merged;
  std::vector<LocalIndex> of_group(distinct.points.size(), no_index), of_point(surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const auto group = static_cast<LocalIndex>(groups.first(at(distinct.of_point[i])));
    const Vec3& x = distinct.points[at(group)];
    if (of_group[at(group)] == no_index) {
      of_group[at(group)] = static_cast<LocalIndex>(merged.surface.points.size());
      merged.surface.points.push_back(x);
    }
    of_point[i] = of_group[at(group)];
    merged.largest_distance = std::max(merged.largest_distance, (surface.points[i] - x).norm());
  }
  merged.merged_points = static_cast<std::int64_t>(surface.points.size() - merged.surface.points.size());
  for (const auto& [p, q, r] : surface.triangles) {
    const std::array<LocalIndex, 3> corners = {of_point[at(p)], of_point[at(q)], of_point[at(r)]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      ++merged.dropped_triangles;
    else
      merged.surface.triangles.push_back(corners);
  }
  return merged;
}

}  // namespace brunt::geometry
