// SPDX-License-Identifier: Apache-2.0
// Index and rank vectors, bisection and contraction.
#include "contact/search/binary_sort.hpp"

#include <algorithm>

namespace brunt::contact {
namespace {

using geometry::Box;

PlaceRange places_between(const std::vector<LocalIndex>& index, std::span<const Vec3> points, int axis, double low,
                          double high) {
  const auto coordinate = [&](LocalIndex p) { return nth(points, p)[axis]; };
  const auto first =
      std::lower_bound(index.begin(), index.end(), low, [&](LocalIndex p, double x) { return coordinate(p) < x; });
  const auto last =
      std::upper_bound(first, index.end(), high, [&](double x, LocalIndex p) { return x < coordinate(p); });
  return {static_cast<LocalIndex>(first - index.begin()), static_cast<LocalIndex>(last - index.begin())};
}

}  // namespace

void sort_along_axes(std::span<const Vec3> points, BinarySort& sorted) {
  std::vector<LocalIndex> finite;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points[p].allFinite()) finite.push_back(static_cast<LocalIndex>(p));
  for (int a = 0; a < 3; ++a) {
    std::vector<LocalIndex>&index = nth(sorted.index, a), &rank = nth(sorted.rank, a);
    index = finite;
    std::stable_sort(index.begin(), index.end(),
                     [&](LocalIndex p, LocalIndex q) { return nth(points, p)[a] < nth(points, q)[a]; });
    rank.assign(points.size(), no_index);
    for (std::size_t place = 0; place < index.size(); ++place) nth(rank, index[place]) = static_cast<LocalIndex>(place);
  }
}

std::array<PlaceRange, 3> places_between(const BinarySort& sorted, std::span<const Vec3> points, const Box& box) {
  std::array<PlaceRange, 3> range;
  for (int a = 0; a < 3; ++a) nth(range, a) = places_between(nth(sorted.index, a), points, a, box.low[a], box.high[a]);
  return range;
}

void append_points_in_box(const BinarySort& sorted, std::span<const Vec3> points, const Box& box,
                          std::vector<LocalIndex>& found) {
  const std::array<PlaceRange, 3> range = places_between(sorted, points, box);
  std::size_t shortest = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (range[a].size() < range[shortest].size()) shortest = a;
  const std::size_t second = (shortest + 1) % 3, third = (shortest + 2) % 3;
  for (LocalIndex place = range[shortest].first; place < range[shortest].last; ++place) {
    const LocalIndex point = nth(sorted.index[shortest], place);
    const auto p = static_cast<std::size_t>(point);
    if (range[second].holds(sorted.rank[second][p]) && range[third].holds(sorted.rank[third][p]))
      found.push_back(point);
  }
}

void find_pairs_by_bisection(const BinarySort& sorted, std::span<const Box> boxes, std::span<const Vec3> points,
                             Ragged<LocalIndex>& pairs) {
  Ragged<LocalIndex> by_box;
  for (const Box& box : boxes) {
    if ((box.low.array() <= box.high.array()).all()) append_points_in_box(sorted, points, box, by_box.values);
    by_box.close_row();
  }
  transpose(by_box, points.size(), pairs);
}

}  // namespace brunt::contact
