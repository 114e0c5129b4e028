// SPDX-License-Identifier: Apache-2.0
#include "weights.hpp"

#include "mortar_slaves.hpp"
#include "scene/build/build.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"
#include "start_rules.hpp"

namespace brunt::app {

/// Measured with tests/bench. A rigid element has no kernel; its nodes are moved, as a tenth of a hexahedron's step.
double cost_of(element::ElementKind kind, bool rigid) {
  constexpr double rigid_cost = 0.1;
  if (rigid) return rigid_cost;
  return kind == element::ElementKind::hex8 ? 1.0 : kind == element::ElementKind::tet4 ? 0.5 : 5.0;
}

partition::Weights weigh(const scene::Input& input, const mesh::CanonicalMesh& whole) {
  std::vector<double> cost;
  for (const std::size_t p : scene::parts_of_blocks(input, whole.mesh))
    cost.push_back(cost_of(input.parts[p].element, scene::is_rigid(input, input.parts[p])));
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
