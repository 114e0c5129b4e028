// SPDX-License-Identifier: Apache-2.0
// Rank-local search by binary sort (Heinstein et al. 2000, section 4.4).
#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "brunt/contact/search/search.hpp"

namespace brunt::contact {
namespace {

/// Points in ascending order of one coordinate; I and R of the paper.
struct SortedAxis {
  std::vector<LocalIndex> point;  ///< I: point at each place of the order
  std::vector<LocalIndex> rank;   ///< R: place of each point in the order
  std::vector<double> value;      ///< coordinate at each place
};

struct Range {
  LocalIndex first = 0, last = 0;  ///< places [first, last)
  [[nodiscard]] LocalIndex size() const { return last - first; }
  [[nodiscard]] bool holds(LocalIndex place) const { return first <= place && place < last; }
};

SortedAxis sort_along(std::span<const Vec3> points, const std::vector<LocalIndex>& near, int axis) {
  SortedAxis sorted;
  sorted.point = near;
  const auto coordinate = [&](LocalIndex p) { return points[static_cast<std::size_t>(p)][axis]; };
  std::sort(sorted.point.begin(), sorted.point.end(), [&](LocalIndex a, LocalIndex b) {
    return coordinate(a) != coordinate(b) ? coordinate(a) < coordinate(b) : a < b;
  });
  sorted.rank.resize(points.size());
  sorted.value.reserve(near.size());
  for (std::size_t place = 0; place < sorted.point.size(); ++place) {
    sorted.rank[static_cast<std::size_t>(sorted.point[place])] = static_cast<LocalIndex>(place);
    sorted.value.push_back(coordinate(sorted.point[place]));
  }
  return sorted;
}

Range places_between(const SortedAxis& axis, double low, double high) {
  const auto first = std::lower_bound(axis.value.begin(), axis.value.end(), low);
  const auto last = std::upper_bound(first, axis.value.end(), high);
  return {static_cast<LocalIndex>(first - axis.value.begin()), static_cast<LocalIndex>(last - axis.value.begin())};
}

void points_in_box(const std::array<SortedAxis, 3>& axes, const geometry::Box& box, std::vector<LocalIndex>& found) {
  if (!(box.low.array() <= box.high.array()).all()) return;
  std::array<Range, 3> range;
  std::size_t shortest = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    range[a] = places_between(axes[a], box.low[static_cast<int>(a)], box.high[static_cast<int>(a)]);
    if (range[a].size() < range[shortest].size()) shortest = a;
  }
  const std::size_t second = (shortest + 1) % 3, third = (shortest + 2) % 3;
  const std::size_t before = found.size();
  for (LocalIndex place = range[shortest].first; place < range[shortest].last; ++place) {
    const LocalIndex point = axes[shortest].point[static_cast<std::size_t>(place)];
    const auto p = static_cast<std::size_t>(point);
    if (range[second].holds(axes[second].rank[p]) && range[third].holds(axes[third].rank[p])) found.push_back(point);
  }
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
}

/// Points in the box around all boxes: what lies outside need not be sorted.
std::vector<LocalIndex> points_in_reach(std::span<const geometry::Box> boxes, std::span<const Vec3> points) {
  geometry::Box all;
  for (const geometry::Box& box : boxes) {
    if (!(box.low.array() <= box.high.array()).all()) continue;
    geometry::extend(all, box.low);
    geometry::extend(all, box.high);
  }
  std::vector<LocalIndex> near;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (geometry::contains(all, points[p])) near.push_back(static_cast<LocalIndex>(p));
  return near;
}

}  // namespace

void find_pairs(std::span<const geometry::Box> boxes, std::span<const Vec3> points, Ragged<LocalIndex>& pairs) {
  const std::vector<LocalIndex> near = points_in_reach(boxes, points);
  geometry::Box occupied;
  for (const LocalIndex p : near) geometry::extend(occupied, points[static_cast<std::size_t>(p)]);
  std::array<SortedAxis, 3> axes;
  for (int a = 0; a < 3; ++a) axes[static_cast<std::size_t>(a)] = sort_along(points, near, a);
  pairs.clear();
  for (const geometry::Box& box : boxes) {
    if (geometry::overlaps(box, occupied)) points_in_box(axes, box, pairs.values);
    pairs.close_row();
  }
}

}  // namespace brunt::contact
