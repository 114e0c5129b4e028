// SPDX-License-Identifier: Apache-2.0
#include "weights.hpp"

#include "mortar_slaves.hpp"
#include "scene/build/build.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"
#include "start_rules.hpp"

namespace brunt::app {

/// Measured with tests/bench; of shells estimated from the number of their points. A rigid element has no kernel; its
/// nodes are moved, as a tenth of a hexahedron's step.
double cost_of(element::ElementKind kind, int points, bool rigid) {
  using element::ElementKind;
  constexpr double rigid_cost = 0.1, of_shell = 0.75, of_point = 0.25;
  if (rigid) return rigid_cost;
  switch (kind) {
    case ElementKind::hex8:
      return 1.0;
    case ElementKind::tet4:
      return 0.5;
    case ElementKind::shell4:
    case ElementKind::shell3:
      return of_shell + of_point * points;
    case ElementKind::shell4_full:
      return of_shell + 4 * of_point * points;
    default:
      return 5.0;
  }
}

partition::Weights weigh(const scene::Input& input, const mesh::CanonicalMesh& whole) {
  std::vector<double> cost;
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, whole.mesh);
  for (std::size_t b = 0; b < part_of.size(); ++b) {
    const scene::Part& part = input.parts[part_of[b]];
    cost.push_back(
        cost_of(scene::kind_of(part, whole.mesh.blocks[b].shape), part.section.points, scene::is_rigid(input, part)));
  }
  if (!scene::contact_specification(input, block_materials(input, whole.mesh).part).pairs.any_acts())
    return partition::weigh(whole.mesh, mortar_slaves(input, whole.mesh), cost);
  const setup::StartRules rules = start_rules(input, whole.mesh);
  const FirstMotion motion = first_motion(input, whole);
  return partition::weigh(whole.mesh,
                          setup::likely_slaves(whole.mesh, setup::contact_faces(whole.mesh, rules.symmetric),
                                               rules.contact, {rules.density, motion.velocity, motion.duration}),
                          cost);
}

}  // namespace brunt::app
