// SPDX-License-Identifier: Apache-2.0
#include "rotation_rules.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/error.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"

namespace brunt::app {

void check_rotation_probes(const Prepared& run) {
  using scene::Probe;
  for (std::size_t k = 0; k < run.input.probes.size(); ++k) {
    const Probe& probe = run.input.probes[k];
    const bool of_nodes = probe.kind != Probe::Kind::joint && !names_rigid_part(run.input, probe.where);
    if (!of_nodes ||
        (probe.field != "rotation" && probe.field != "angular_velocity" && probe.field != "reaction_moment"))
      continue;
    const auto& nodes = run.model.mesh.node_sets.at(scene::selection_name("probe", k));
    const bool turns = std::ranges::any_of(
        nodes, [&](LocalIndex node) { return std::ranges::binary_search(run.model.turning, node); });
    if (!run.links.ranks.any(turns))
      throw InputError(
          fmt::format("{}: invalid field '{}': none of these nodes belongs to a shell or a rigid part, so "
                      "none turns; expected displacement, velocity or position",
                      run.input.at(fmt::format("probes.{}.field", k)), probe.field));
  }
}

}  // namespace brunt::app
