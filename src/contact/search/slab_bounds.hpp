// SPDX-License-Identifier: Apache-2.0
// Discrete oriented polytopes (k-DOPs): the intersection of `slabs` = k/2 slabs, of which the least and the greatest
// projection are stored (Klosowski et al. 1998). The directions are not normalised, so a projection is a sum of two
// coordinates. They come in groups of three, one quad each:
//
//   group 0   x, y, z             3 slabs: a box along the axes
//   group 1   x+y, y+z, z+x
//   group 2   x-y, y-z, z-x       9 slabs: an 18-DOP; geometry::more_directions(9) are the same directions, normalised
#pragma once
#include <numbers>

#include "core/simd.hpp"
#include "core/types.hpp"

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace brunt::contact {

/// The fourth lane of each quad is unused: it has the same interval in all bounds.
template <int slabs>
struct SlabBounds {
  static_assert(slabs == 3 || slabs == 9);
  static constexpr int groups = slabs / 3;
  Quad low[groups], high[groups];  ///< [length]
};

/// Every bound moves outwards by this amount in the coordinate of its slab [length], >= 0.
struct Enlargement {
  double axes = 0, diagonals = 0;
};

/// A surface grown by the distance `d` [length] stays within bounds enlarged by this: a diagonal direction has length
/// sqrt(2).
inline Enlargement by_distance(double d) {
  return {d, std::numbers::sqrt2 * d};
}

BRUNT_INLINE Quad quad_min(Quad a, Quad b) {
  return a < b ? a : b;
}
BRUNT_INLINE Quad quad_max(Quad a, Quad b) {
  return a > b ? a : b;
}

/// Projections of a point on the slabs.
template <int slabs>
BRUNT_INLINE void project(const Vec3& point, Quad (&along)[slabs / 3]) {
  const Quad x{point[0], point[1], point[2], 0.0};
  along[0] = x;
  if constexpr (slabs == 9) {
    const Quad next = __builtin_shufflevector(x, x, 1, 2, 0, 3);
    along[1] = x + next;
    along[2] = x - next;
  }
}

/// Bounds of the convex hull of four points. The projections are rounded, so bounds that must contain the complete hull
/// need an enlargement by one rounding of the coordinates.
template <int slabs>
BRUNT_INLINE SlabBounds<slabs> bounds_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                         const Enlargement& by) {
  constexpr int groups = slabs / 3;
  Quad along[4][groups];
  project<slabs>(a, along[0]);
  project<slabs>(b, along[1]);
  project<slabs>(c, along[2]);
  project<slabs>(d, along[3]);
  SlabBounds<slabs> bounds;
  for (int g = 0; g < groups; ++g) {
    const double margin = g == 0 ? by.axes : by.diagonals;
    bounds.low[g] = quad_min(quad_min(along[0][g], along[1][g]), quad_min(along[2][g], along[3][g])) - margin;
    bounds.high[g] = quad_max(quad_max(along[0][g], along[1][g]), quad_max(along[2][g], along[3][g])) + margin;
  }
  return bounds;
}

/// The smallest bounds that contain both.
template <int slabs>
BRUNT_INLINE SlabBounds<slabs> united(const SlabBounds<slabs>& a, const SlabBounds<slabs>& b) {
  SlabBounds<slabs> both;
  for (int g = 0; g < slabs / 3; ++g) {
    both.low[g] = quad_min(a.low[g], b.low[g]);
    both.high[g] = quad_max(a.high[g], b.high[g]);
  }
  return both;
}

/// Whether all lanes are true.
BRUNT_INLINE bool all_lanes(QuadMask mask) {
#ifdef __AVX__
  return _mm256_movemask_pd((__m256d)mask) == 0xF;  // the same bits as another type: NOLINT
#else
  return all(mask);
#endif
}

/// Whether all intervals overlap; they are closed. A NaN overlaps nothing.
template <int slabs>
BRUNT_INLINE bool overlap(const SlabBounds<slabs>& a, const SlabBounds<slabs>& b) {
  for (int g = 0; g < slabs / 3; ++g)
    if (!all_lanes((a.low[g] <= b.high[g]) & (b.low[g] <= a.high[g]))) return false;
  return true;
}

/// Sum of the widths of all slabs [length], by which a traversal descends the larger of two nodes. It replaces the
/// volume, which is costly for nine slabs and 0 for flat facets along the axes; the number of tests is the same as with
/// products of widths.
template <int slabs>
BRUNT_INLINE double width(const SlabBounds<slabs>& bounds) {
  Quad sum = bounds.high[0] - bounds.low[0];
  for (int g = 1; g < slabs / 3; ++g) sum += bounds.high[g] - bounds.low[g];
  return sum[0] + sum[1] + sum[2];
}

}  // namespace brunt::contact
