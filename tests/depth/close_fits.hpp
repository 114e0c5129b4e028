// SPDX-License-Identifier: Apache-2.0
// Machine parts in their counterparts, pushed into each other a little: a free placement near by is known.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/triangle_surface.hpp"
#include "depth/rigid_motion.hpp"

namespace brunt::test {

struct CloseFit {
  std::string name;
  TriangleSurface a, b;
  Placement a_in_b;       ///< overlapping
  Placement fits;         ///< free: as the parts were designed
  double clearance = 0;   ///< all round, at `fits` [length]
  double push = 0;        ///< greatest distance of a point of A from its place at `fits` [length]
  bool straight = false;  ///< `a_in_b` follows from `fits` by a translation
};

/// Shafts, keys, lids, gears and threads.
inline constexpr int fit_kinds = 5;

/// Sizes, numbers of facets and the push are random. `kind` is below `fit_kinds`.
CloseFit close_fit(int kind, bool straight, std::uint64_t seed);

}  // namespace brunt::test
