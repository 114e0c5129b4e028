// SPDX-License-Identifier: Apache-2.0
// The points that may be vertices of the convex hull. A point is omitted only with a proof: a convex combination of
// retained points that is at most 1e-13 of the size away from it. The maximum of a convex function of the points is
// thus preserved to this accuracy. The proof is the infeasibility of d . (x - e) >= 1 for all e in a set of supporting
// points.
#pragma once
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt::depth {

/// In the order of the points. The set has at most 512 supporting points; with more hull vertices, interior points may
/// be retained (which only costs time).
[[nodiscard]] std::vector<Vec3> extreme_points(std::span<const Vec3> points);

/// `count` unit vectors distributed evenly over the sphere (Fibonacci lattice); the same on every call.
[[nodiscard]] std::vector<Vec3> spread_directions(int count);

}  // namespace brunt::depth
