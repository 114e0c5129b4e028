// SPDX-License-Identifier: Apache-2.0
#include "setup/start_rules.hpp"

#include <algorithm>

#include "mesh/topology.hpp"

namespace brunt::setup {

std::vector<mesh::Side> contact_faces(const mesh::Mesh& mesh, const std::vector<std::vector<LocalIndex>>& symmetric) {
  std::vector<mesh::Side> faces = mesh::exterior_sides(mesh);
  for (const std::vector<LocalIndex>& plane : symmetric)
    std::erase_if(faces, [&](const mesh::Side& side) {
      const mesh::Block& block = nth(mesh.blocks, side.block);
      return std::ranges::all_of(
          mesh::face_nodes(block.shape, block.element(side.element), side.face),
          [&](LocalIndex node) { return node == no_index || std::ranges::binary_search(plane, node); });
    });
  return faces;
}

}  // namespace brunt::setup
