// SPDX-License-Identifier: Apache-2.0
// Shapes of the hexahedra of a generated body.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/cells.hpp"
#include "mesh/mesh.hpp"

namespace brunt::mesh {

/// Smallest scaled Jacobian: triple product of the unit edges at a corner. Corners of collapsed edges are left out.
inline double worst_shape(const Mesh& mesh) {
  double worst = 1;
  for (LocalIndex e = 0; e < mesh.blocks[0].count(); ++e)
    for (std::size_t k = 0; k < 8; ++k) {
      const LocalIndex* nodes = mesh.blocks[0].element(e);
      const auto& ends = cells::hex_neighbours[k];
      if (std::ranges::any_of(ends, [&](int end) { return nodes[end] == nodes[k]; })) continue;
      const auto edge = [&](int i) {
        return (mesh.coordinates[static_cast<std::size_t>(nodes[ends[static_cast<std::size_t>(i)]])] -
                mesh.coordinates[static_cast<std::size_t>(nodes[k])])
            .normalized();
      };
      worst = std::min(worst, edge(0).cross(edge(1)).dot(edge(2)));
    }
  return worst;
}

}  // namespace brunt::mesh
