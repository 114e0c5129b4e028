// SPDX-License-Identifier: Apache-2.0
// Sums whose bits do not depend on the order of the terms (after Demmel and Nguyen, Fast reproducible floating-point
// summation, ARITH 2013). Each term is split into slices on fixed binary grids, a coarse and a fine one. Sums of slices
// on one grid are exact while they have few enough terms, so they may be formed in any order and in parts on different
// ranks. The slices are added and rounded once at the end. The bound on the terms is known beforehand, so no carry has
// to be propagated.
#pragma once
#include <algorithm>
#include <cmath>

namespace brunt {

/// Number of slices of a term: two keep all bits of terms down to 2^-20 of the bound.
constexpr int bin_slices = 2;

/// Largest number of terms (as a power of two) for which a sum is exact.
constexpr int binned_terms_log2 = 14;
constexpr double binned_terms = 1 << binned_terms_log2;

/// The grids for terms of a given largest magnitude.
struct BinGrid {
  double anchor[bin_slices] = {0, 0};  ///< (x + anchor) - anchor rounds x to the grid

  /// bound: at least the largest |term|, the same on all ranks, finite.
  static BinGrid for_bound(double bound);
};

/// Adds one term to slices[0], slices[1]; |term| <= the bound of the grid.
inline void binned_add(const BinGrid& grid, double term, double* slices) {
  const double coarse = (term + grid.anchor[0]) - grid.anchor[0];
  const double rest = term - coarse;  // exact
  slices[0] += coarse;
  slices[1] += (rest + grid.anchor[1]) - grid.anchor[1];
}

/// The sum, rounded once.
inline double binned_value(const double* slices) {
  return slices[0] + slices[1];
}

inline BinGrid BinGrid::for_bound(double bound) {
  if (!(bound > 0)) return {};
  // A sum of 2^t terms below 2^e on the grid 2^(e+t-52) stays below 2^53 grid units. The last place of the anchor 1.5 *
  // 2^(e+t) is this grid. The remainder of a term is at most half a unit, which bounds the next slice.
  int exponent = 0;
  std::frexp(bound, &exponent);
  BinGrid grid;
  exponent = std::max(exponent, -940);  // keeps the finest grid clear of subnormal numbers
  for (double& anchor : grid.anchor) {
    anchor = std::ldexp(1.5, exponent + binned_terms_log2);
    exponent += binned_terms_log2 - 53;
  }
  return grid;
}

}  // namespace brunt
