// SPDX-License-Identifier: Apache-2.0
// Bucket sort of points and collection of those in the buckets of a box.
#include "contact/search/bucket_sort.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brunt::contact {
namespace {

using geometry::Box;

Box finite_extent(std::span<const Vec3> points) {
  Box extent;
  for (const Vec3& point : points)
    if (point.allFinite()) geometry::extend(extent, point);
  return extent;
}

/// Number of buckets, as a double: too many for an index is a case to be met.
double buckets_needed(const Box& extent, double size) {
  double count = 1;
  for (int a = 0; a < 3; ++a) count *= std::floor((extent.high[a] - extent.low[a]) / size) + 1;
  return count;
}

double smallest_face(std::span<const Box> boxes) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Box& box : boxes) {
    const double longest = (box.high - box.low).maxCoeff();
    if (longest > 0) smallest = std::min(smallest, longest);
  }
  return smallest;
}

}  // namespace

std::size_t BucketGrid::bucket_count() const {
  return static_cast<std::size_t>(slices[0]) * static_cast<std::size_t>(slices[1]) *
         static_cast<std::size_t>(slices[2]);
}

LocalIndex BucketGrid::slice(double coordinate, int axis) const {
  const auto last = static_cast<double>(nth(slices, axis) - 1);
  const double slice = (coordinate - low[axis]) / size;
  return static_cast<LocalIndex>(std::max(0.0, std::min(last, slice)));  // a NaN falls into the last
}

BucketGrid bucket_grid(std::span<const Vec3> points, double size) {
  const Box extent = finite_extent(points);
  BucketGrid grid;
  grid.size = size;
  if (!(extent.low.array() <= extent.high.array()).all()) return grid;
  grid.low = extent.low;
  for (int a = 0; a < 3; ++a)
    nth(grid.slices, a) = static_cast<LocalIndex>((extent.high[a] - extent.low[a]) / size) + 1;
  return grid;
}

BucketGrid bucket_grid(std::span<const Vec3> points, std::span<const Box> boxes, std::size_t most_buckets) {
  const Box extent = finite_extent(points);
  const auto most = static_cast<double>(std::max<std::size_t>(1, most_buckets));
  const double longest = std::max(0.0, (extent.high - extent.low).maxCoeff());
  if (!std::isfinite(longest)) return {};  // one bucket
  double size = std::max(smallest_face(boxes), longest / most);
  if (!std::isfinite(size) || size <= 0) size = longest > 0 ? longest : 1;
  while (buckets_needed(extent, size) > most) size *= 1.05;
  return bucket_grid(points, size);
}

void sort_into_buckets(std::span<const Vec3> points, const BucketGrid& grid, BucketSort& sorted) {
  sorted.grid = grid;
  const std::size_t count = points.size();
  sorted.lbox.resize(count);
  sorted.ndsort.resize(count);
  sorted.nbox.assign(grid.bucket_count(), 0);
  sorted.npoint.resize(grid.bucket_count());
  for (std::size_t i = 0; i < count; ++i) {
    const LocalIndex x = grid.slice(points[i][0], 0), y = grid.slice(points[i][1], 1), z = grid.slice(points[i][2], 2);
    sorted.lbox[i] = (z * grid.slices[1] + y) * grid.slices[0] + x;
    ++nth(sorted.nbox, sorted.lbox[i]);
  }
  LocalIndex place = 0;
  for (std::size_t j = 0; j < sorted.nbox.size(); ++j) {
    sorted.npoint[j] = place;
    place += sorted.nbox[j];
  }
  std::fill(sorted.nbox.begin(), sorted.nbox.end(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bucket = static_cast<std::size_t>(sorted.lbox[i]);
    const LocalIndex place_of_point = sorted.npoint[bucket] + sorted.nbox[bucket]++;
    nth(sorted.ndsort, place_of_point) = static_cast<LocalIndex>(i);
  }
}

BucketRange buckets_of(const BucketGrid& grid, const Box& box) {
  BucketRange range;
  for (int a = 0; a < 3; ++a) {
    nth(range.first, a) = grid.slice(box.low[a], a);
    nth(range.last, a) = grid.slice(box.high[a], a);
  }
  return range;
}

void append_candidates(const BucketSort& sorted, const Box& box, std::vector<LocalIndex>& candidates) {
  const auto& slices = sorted.grid.slices;
  const auto [first, last] = buckets_of(sorted.grid, box);
  for (LocalIndex i = first[0]; i <= last[0]; ++i)
    for (LocalIndex j = first[1]; j <= last[1]; ++j)
      for (LocalIndex k = first[2]; k <= last[2]; ++k) {
        const std::ptrdiff_t row = std::ptrdiff_t{k} * slices[1] + j;
        const auto bucket = static_cast<std::size_t>(row * slices[0] + i);
        const auto begin = sorted.ndsort.begin() + sorted.npoint[bucket];
        candidates.insert(candidates.end(), begin, begin + sorted.nbox[bucket]);
      }
}

void find_pairs_in_buckets(const BucketSort& sorted, std::span<const Box> boxes, std::span<const Vec3> points,
                           Ragged<LocalIndex>& pairs) {
  Ragged<LocalIndex> by_box;
  std::vector<LocalIndex> candidates;
  for (const Box& box : boxes) {
    candidates.clear();
    if ((box.low.array() <= box.high.array()).all()) append_candidates(sorted, box, candidates);
    for (const LocalIndex p : candidates) {
      const Vec3& point = nth(points, p);
      if (geometry::contains(box, point) && point.allFinite()) by_box.values.push_back(p);
    }
    by_box.close_row();
  }
  transpose(by_box, points.size(), pairs);
}

}  // namespace brunt::contact
