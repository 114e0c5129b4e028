// SPDX-License-Identifier: Apache-2.0
// Vectors of nodes in arrays with three doubles for each node.
#pragma once
#include <vector>

#include "core/simd.hpp"
#include "core/types.hpp"

namespace brunt::implicit {

inline Vec3 of(const Quad& q) {
  return {q[0], q[1], q[2]};
}

/// Zero if the array is empty: a feature that the scene does not use.
inline Vec3 of(const std::vector<double>& nodal, std::size_t node) {
  return nodal.empty() ? Vec3(Vec3::Zero()) : Vec3(&nodal[3 * node]);
}

inline void put(const Vec3& value, std::vector<double>& nodal, std::size_t node) {
  for (std::size_t c = 0; c < 3; ++c) nodal[3 * node + c] = value[static_cast<int>(c)];
}

}  // namespace brunt::implicit
