// SPDX-License-Identifier: Apache-2.0
#include "weights.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "brunt/contact/likely_slaves.hpp"
#include "brunt/mesh/topology.hpp"
#include "brunt/scene/build.hpp"
#include "brunt/scene/select.hpp"
#include "contact_setup.hpp"

namespace brunt::app {
namespace {

/// Time of an element relative to the one-point hexahedron, measured with tests/bench.
double cost_of(element::ElementKind kind) {
  return kind == element::ElementKind::hex8 ? 1.0 : kind == element::ElementKind::tet4 ? 0.5 : 5.0;
}

}  // namespace

std::vector<mesh::Side> contact_faces(const scene::Input& input, const mesh::Mesh& mesh) {
  std::vector<mesh::Side> faces = mesh::exterior_sides(mesh);
  for (std::size_t k = 0; k < input.symmetry.size(); ++k) {
    const std::vector<LocalIndex>& plane = mesh.node_sets.at(scene::selection_name("symmetry", k));
    std::erase_if(faces, [&](const mesh::Side& side) {
      const mesh::Block& block = mesh.blocks[static_cast<std::size_t>(side.block)];
      return std::ranges::all_of(
          mesh::face_nodes(block.shape, block.element(side.element), side.face),
          [&](LocalIndex node) { return node == no_index || std::ranges::binary_search(plane, node); });
    });
  }
  return faces;
}

BlockMaterials block_materials(const scene::Input& input, const mesh::Mesh& mesh) {
  BlockMaterials blocks;
  for (const std::size_t p : scene::parts_of_blocks(input, mesh)) {
    const scene::Part& part = input.parts[p];
    blocks.part.push_back(part.name);
    blocks.density.push_back(material::initial_moduli(input.materials.at(part.material)).density);
  }
  return blocks;
}

partition::Weights weigh(const scene::Input& input, const mesh::CanonicalMesh& whole) {
  std::vector<double> cost;
  for (const std::size_t p : scene::parts_of_blocks(input, whole.mesh)) cost.push_back(cost_of(input.parts[p].element));
  const BlockMaterials blocks = block_materials(input, whole.mesh);
  const model::ContactRule rule = scene::contact_rule(input, blocks.part);
  if (!rule.any) return partition::weigh(whole.mesh, {}, cost);
  const std::vector<Vec3> velocity =
      scene::initial_velocities(input, whole.mesh.coordinates, whole.origin, whole.mesh.node_sets);
  const double duration = input.run.end.value_or(std::numeric_limits<double>::infinity());
  return partition::weigh(whole.mesh,
                          contact::likely_slaves(whole.mesh, contact_faces(input, whole.mesh),
                                                 pair_table(rule, cost.size()), {blocks.density, velocity, duration}),
                          cost);
}

}  // namespace brunt::app
