// SPDX-License-Identifier: Apache-2.0
// Boxes of hexahedra as tetrahedra.
#pragma once
#include <utility>

#include "mesh/mesh.hpp"

namespace brunt::test {

/// Six tetrahedra for each hexahedron of the first block, around its diagonal.
inline mesh::Mesh in_tetrahedra(mesh::Mesh mesh) {
  constexpr int around[6][2] = {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}};  // of the diagonal 0-6
  mesh::Block& block = mesh.blocks[0];
  mesh::Block tets{.name = block.name, .id = block.id, .shape = mesh::Shape::tet4, .nodes = {}, .element_id = {}};
  for (LocalIndex e = 0; e < block.count(); ++e)
    for (const auto& [a, b] : around) {
      const LocalIndex* hex = block.element(e);
      for (const LocalIndex node : {hex[0], hex[a], hex[b], hex[6]}) tets.nodes.push_back(node);
      tets.element_id.push_back(static_cast<GlobalIndex>(tets.element_id.size() + 1));
    }
  block = std::move(tets);
  mesh.side_sets.clear();
  return mesh;
}

}  // namespace brunt::test
