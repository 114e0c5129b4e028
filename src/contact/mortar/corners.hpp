// SPDX-License-Identifier: Apache-2.0
// Corners of a facet, whose nodes are numbers of one array.
#pragma once
#include <array>
#include <span>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// Positions of the three or four corners [length].
struct CornersOf {
  std::array<Vec3, 4> x;
  std::size_t count = 0;

  CornersOf(const FacetNodes& nodes, std::span<const Vec3> positions) {
    for (const LocalIndex node : nodes)
      if (node != no_index) x[count++] = nth(positions, node);
  }
  [[nodiscard]] FacetCorners span() const { return {x.data(), count}; }
};

}  // namespace brunt::contact
