// SPDX-License-Identifier: Apache-2.0
// Proven lower bounds of penetration depth at one placement.
//
// With phi_A, phi_B the depths of a point in both bodies (positive inside): a ball of radius phi_A about the material
// point of A at y and one of radius phi_B about y in B must part, so that this point moves by at least
//   g(y) = phi_A(y) + phi_B(y).
// Hence PDt >= PDg >= max g in the displacement metric, and in the object norm g / sqrt(factor of the point), see
// point_factor. Any point gives a valid bound; g is increased from the best balls by ascent. Convex pieces a in A and b
// in B give PDg >= PDt(a, b) in the displacement metric: see convex_pair. The object norm is the root mean square of
// the points' motions as well, sigma >= (1/V) integral over A of max(0, g)^2: a lower sum over inner cells.
#pragma once
#include <cstddef>

#include "brunt/depth/encounter.hpp"

namespace brunt::depth {

struct LowerBound {
  double value = 0;           ///< [length]; 0 where nothing is proven
  Vec3 point = Vec3::Zero();  ///< y, in the coordinates of B [length]
};

/// How far the greatest sum of depths is looked for; any point gives a valid bound.
struct BoundEffort {
  std::size_t ascents;    ///< from so many of the best points
  int looks, more_looks;  ///< at points, of an ascent, and of the best one then
};
constexpr BoundEffort quick_bound{2, 8, 0};  ///< a small part of a fast query: mostly within a few percent of the top
constexpr BoundEffort thorough_bound{6, 40,
                                     300};  ///< to the top within rounding: hardly any ascent needs a hundred looks

/// At the given placement. Depths are exact to rounding, so is the bound.
[[nodiscard]] LowerBound lower_bound(const Encounter& encounter, Metric metric,
                                     const BoundEffort& effort = thorough_bound);

}  // namespace brunt::depth
