// SPDX-License-Identifier: Apache-2.0
// Which points may be vertices of the convex hull. A point is left out only with a proof: a convex combination of other
// points that stay, at most 1e-13 of the size away from it. What maximises a convex function of points is therefore
// kept to that accuracy. The proof is the infeasibility of d . (x - e) >= 1 for all e in a set of supporting points.
#pragma once
#include <span>
#include <vector>

#include "brunt/core/types.hpp"

namespace brunt::depth {

/// In the order of the points. At most 512 supporting points serve as the set; with more hull vertices than that,
/// points inside may stay (only speed is lost).
[[nodiscard]] std::vector<Vec3> extreme_points(std::span<const Vec3> points);

/// `count` unit vectors spread evenly over the sphere (Fibonacci lattice); the same on every call.
[[nodiscard]] std::vector<Vec3> spread_directions(int count);

}  // namespace brunt::depth
