// SPDX-License-Identifier: Apache-2.0
#include "start_rules.hpp"

#include <fmt/core.h>

#include <limits>

#include "scene/build/build.hpp"
#include "scene/build/select.hpp"

namespace brunt::app {

BlockMaterials block_materials(const scene::Input& input, const mesh::Mesh& mesh) {
  BlockMaterials blocks;
  for (const std::size_t p : scene::parts_of_blocks(input, mesh)) {
    const scene::Part& part = input.parts[p];
    blocks.part.push_back(part.name);
    blocks.density.push_back(material::initial_moduli(input.materials.at(part.material)).density);
  }
  return blocks;
}

setup::StartRules start_rules(const scene::Input& input, const mesh::Mesh& mesh) {
  BlockMaterials blocks = block_materials(input, mesh);
  setup::StartRules rules;
  for (const std::string& a : blocks.part)
    for (const std::string& b : blocks.part) rules.overlap.push_back(scene::overlap_rule(input, a, b));
  rules.contact = scene::contact_specification(input, blocks.part);
  rules.density = std::move(blocks.density);
  for (std::size_t k = 0; k < input.symmetry.size(); ++k)
    rules.symmetric.push_back(mesh.node_sets.at(scene::selection_name("symmetry", k)));
  return rules;
}

FirstMotion first_motion(const scene::Input& input, const mesh::CanonicalMesh& whole) {
  return {scene::initial_velocities(input, whole.mesh.coordinates, whole.origin, whole.mesh.node_sets),
          input.run.end.value_or(std::numeric_limits<double>::infinity())};
}

HeldByScene held_nodes(const scene::Input& input, const mesh::Mesh& mesh) {
  HeldByScene held;
  const auto add = [&](const std::string& kind, std::size_t entry, const Vec3& direction) {
    held.nodes.push_back({mesh.node_sets.at(scene::selection_name(kind, entry)), direction});
    held.key.push_back(fmt::format("{}.{}", kind, entry));
  };
  for (std::size_t k = 0; k < input.fixed.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (nth(input.fixed[k].dofs, c)) add("fixed", k, Vec3::Unit(c));
  for (std::size_t k = 0; k < input.symmetry.size(); ++k) add("symmetry", k, input.symmetry[k].normal.normalized());
  for (std::size_t k = 0; k < input.prescribed.size(); ++k)
    if (const int dof = input.prescribed[k].dof; dof < 3) add("prescribed", k, Vec3::Unit(dof));
  return held;
}

}  // namespace brunt::app
