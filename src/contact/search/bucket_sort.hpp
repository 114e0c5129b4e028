// SPDX-License-Identifier: Apache-2.0
// The bucket sort of Heinstein et al. 2000, section 4.3, as printed; a reference for the search in use (search.hpp).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/ragged.hpp"
#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::contact {

/// Cubic buckets over the points' bounding box, numbered along x, then y, then z. Indices count from 0, not from 1.
struct BucketGrid {
  Vec3 low = Vec3::Zero();                    ///< x_min, y_min, z_min
  double size = 1;                            ///< b_s [length]
  std::array<LocalIndex, 3> slices{1, 1, 1};  ///< S_x, S_y, S_z

  [[nodiscard]] std::size_t bucket_count() const;  ///< n_b
  /// Slice of a coordinate: int[(x - x_min) / b_s], or the first or last one for coordinates outside. The quotient is
  /// computed as printed: it is exact for a point on a border if b_s divides its coordinate.
  [[nodiscard]] LocalIndex slice(double coordinate, int axis) const;
};

/// Grid of buckets of edge `size` over all finite points.
BucketGrid bucket_grid(std::span<const Vec3> points, double size);

/// As above with the edge of the smallest box (its longest side, since the box of a face may be flat), or a larger one
/// that needs at most `most_buckets`: the size affects speed and memory, never the pairs.
BucketGrid bucket_grid(std::span<const Vec3> points, std::span<const geometry::Box> boxes, std::size_t most_buckets);

/// Buckets for so many points: some eight a point, so that memory stays in proportion where points are far apart.
constexpr std::size_t most_buckets(std::size_t points) {
  return 8 * points + 64;
}

/// The four vectors of the paper. 18 n + 2 n_b places with those of its work on candidates.
struct BucketSort {
  BucketGrid grid;
  std::vector<LocalIndex> lbox;    ///< bucket of each point
  std::vector<LocalIndex> nbox;    ///< number of points of each bucket
  std::vector<LocalIndex> npoint;  ///< place in ndsort of the first point of each bucket
  std::vector<LocalIndex> ndsort;  ///< points by bucket, ascending in each
};

void sort_into_buckets(std::span<const Vec3> points, const BucketGrid& grid, BucketSort& sorted);

/// Buckets that a box occupies, from first to last on each axis (ibox_min ... kbox_max).
struct BucketRange {
  std::array<LocalIndex, 3> first{}, last{};
};
BucketRange buckets_of(const BucketGrid& grid, const geometry::Box& box);

/// Appends all points of the buckets that the box occupies, including points outside the box.
void append_candidates(const BucketSort& sorted, const geometry::Box& box, std::vector<LocalIndex>& candidates);

/// pairs row p: the boxes that contain point p, ascending, as in find_pairs (search.hpp).
void find_pairs_in_buckets(const BucketSort& sorted, std::span<const geometry::Box> boxes, std::span<const Vec3> points,
                           Ragged<LocalIndex>& pairs);

}  // namespace brunt::contact
