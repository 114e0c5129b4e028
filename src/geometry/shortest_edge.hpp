// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/types.hpp"

namespace brunt::geometry {

/// Shortest edge of a face; the edge of a repeated corner does not count [length].
inline double shortest_edge(std::span<const Vec3> corners) {
  double least2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double edge2 = (corners[(i + 1) % corners.size()] - corners[i]).squaredNorm();
    if (edge2 > 0) least2 = std::min(least2, edge2);
  }
  return std::sqrt(least2);
}

}  // namespace brunt::geometry
