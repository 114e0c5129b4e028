// SPDX-License-Identifier: Apache-2.0
#include "rotation_probes.hpp"

#include <algorithm>
#include <array>

#include "body_probes.hpp"
#include "comm/exact_sum.hpp"
#include "scene/build/select.hpp"

namespace brunt::app {
namespace {

using scene::Probe;

/// Calls visit(node) for the nodes of the probe that turn and that this rank owns.
template <class Visit>
void for_turning(const Prepared& run, std::size_t probe, Visit&& visit) {
  const auto& nodes = run.model.mesh.node_sets.at(scene::selection_name("probe", probe));
  for (const LocalIndex node : nodes)
    if (std::ranges::binary_search(run.model.turning, node) && std::ranges::binary_search(run.model.owned, node))
      visit(static_cast<std::size_t>(node));
}

/// Of three components and a weight.
std::array<double, 4> rounded(const Prepared& run, std::array<comm::ExactAccumulator, 4>& sums) {
  std::array<double, 4> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return value;
}

}  // namespace

bool is_rotation_of_nodes(const Prepared& run, std::size_t probe) {
  const Probe& asked = run.input.probes[probe];
  if (asked.kind == Probe::Kind::joint) return false;
  if (asked.kind == Probe::Kind::part && body_of_part(run.model, asked.where)) return false;
  return asked.field == "rotation" || asked.field == "angular_velocity" || asked.field == "reaction_moment";
}

Vec3 mean_rotation(const Prepared& run, std::size_t probe) {
  std::array<comm::ExactAccumulator, 4> sums;
  const bool turned = run.input.probes[probe].field == "rotation";
  for_turning(run, probe, [&](std::size_t i) {
    const model::RotationLine& line = run.state.rotations[i];
    const Vec3 value = turned ? rotation_vector(Eigen::Quaterniond(line.turn)) : Vec3(line.rate);
    for (std::size_t c = 0; c < 3; ++c) sums[c].add(line.inertia * value[static_cast<int>(c)]);
    sums[3].add(line.inertia);
  });
  const std::array<double, 4> value = rounded(run, sums);
  return Vec3(value[0], value[1], value[2]) / value[3];
}

Vec3 rotation_reaction(const Prepared& run, std::size_t probe) {
  std::array<comm::ExactAccumulator, 4> sums;
  for_turning(run, probe, [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) sums[c].add(run.state.rotation_accounts[i].reaction_impulse[c]);
  });
  const std::array<double, 4> value = rounded(run, sums);
  return {value[0], value[1], value[2]};
}

}  // namespace brunt::app
