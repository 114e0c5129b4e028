// SPDX-License-Identifier: Apache-2.0
// Proven lower bounds of penetration depth at one placement.
//
// Let phi_A, phi_B be the depths of a point in both bodies (positive inside). A ball of radius phi_A about the material
// point of A at y and one of radius phi_B about y in B must be separated, so this point moves by at least
//   g(y) = phi_A(y) + phi_B(y).
// Hence PDt >= PDg >= max g in the displacement metric, and in the object norm g / sqrt(factor of the point), see
// point_factor. Any point gives a valid bound; g is increased from the best balls by ascent. Convex pieces a in A and b
// in B give PDg >= PDt(a, b) in the displacement metric: see convex_pair. The object norm is also the root mean square
// of the points' displacements, so sigma >= (1/V) integral over A of max(0, g)^2: a lower sum over inner cells.
#pragma once
#include <cstddef>

#include "depth/encounter.hpp"

namespace brunt::depth {

struct LowerBound {
  double value = 0;           ///< [length]; 0 if nothing is proven
  Vec3 point = Vec3::Zero();  ///< y, in the coordinates of B [length]
};

/// Effort of the search for the largest sum of depths; any point gives a valid bound.
struct BoundEffort {
  std::size_t ascents;    ///< from this number of the best points
  int looks, more_looks;  ///< evaluations of an ascent, and further ones of the best ascent
};
constexpr BoundEffort quick_bound{2, 8,
                                  0};  ///< a small part of a fast query: mostly within a few percent of the maximum
constexpr BoundEffort thorough_bound{6, 40,
                                     300};  ///< to the top within rounding: hardly any ascent needs a hundred looks

/// At the given placement. Depths and the bound are exact up to rounding.
[[nodiscard]] LowerBound lower_bound(const Encounter& encounter, Metric metric,
                                     const BoundEffort& effort = thorough_bound);

}  // namespace brunt::depth
