// SPDX-License-Identifier: Apache-2.0
#include "probes.hpp"

#include <algorithm>

#include "brunt/comm/exact_sum.hpp"
#include "brunt/scene/select.hpp"

namespace brunt::app {
namespace {

using scene::Probe;

bool is_force(const Probe& probe) {
  return probe.kind == Probe::Kind::wall || probe.kind == Probe::Kind::contact || probe.field == "reaction";
}

/// Calls visit(node) for the nodes of the probe that this rank owns.
template <class Visit>
void for_owned(const Prepared& run, std::size_t probe, Visit&& visit) {
  const auto& nodes = run.model.mesh.node_sets.at(scene::selection_name("probe", probe));
  for (const LocalIndex node : nodes)
    if (std::ranges::binary_search(run.model.owned, node)) visit(static_cast<std::size_t>(node));
}

/// Mean over the nodes, each with its mass as weight: the motion of their centre of mass.
Vec3 mean_motion(const Prepared& run, std::size_t index) {
  const Probe& probe = run.input.probes[index];
  std::array<comm::ExactAccumulator, 4> sums;
  for_owned(run, index, [&](std::size_t i) {
    const model::NodeLine& node = run.state.nodes[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto k = static_cast<int>(c);
      const double value = probe.field == "velocity"       ? node.v[c]
                           : probe.field == "displacement" ? run.state.displacement[i][k]
                                                           : node.x[c] + run.model.mesh.origin[k];
      sums[c].add(node.mass * value);
    }
    sums[3].add(node.mass);
  });
  std::array<double, 4> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return Vec3(value[0], value[1], value[2]) / value[3];
}

Vec3 reaction_impulse(const Prepared& run, std::size_t index) {
  std::array<comm::ExactAccumulator, 3> sums;
  if (run.model.any_constrained)
    for_owned(run, index, [&](std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c) sums[c].add(run.state.reaction_impulse[3 * i + c]);
    });
  std::array<double, 3> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return {value[0], value[1], value[2]};
}

}  // namespace

Probes::Probes(const Prepared& run, const scene::UnitSystem& units) : motion_(run.input.probes.size(), Vec3::Zero()) {
  for (const Probe& probe : run.input.probes)
    for (const char* component : {"x", "y", "z"}) {
      if (!is_force(probe)) {
        columns_.push_back({probe.name + '.' + component, probe.field == "velocity" ? units.velocity : units.length});
      } else {
        columns_.push_back({probe.name + '.' + component, units.force});
        columns_.push_back({"impulse_" + probe.name + '.' + component, units.momentum});
      }
    }
}

void Probes::read_motion(const Prepared& run) {
  for (std::size_t k = 0; k < motion_.size(); ++k)
    if (!is_force(run.input.probes[k])) motion_[k] = mean_motion(run, k);
}

std::vector<double> Probes::values(Prepared& run, const contact::ContactTotals& totals) {
  std::vector<double> row;
  for (std::size_t k = 0; k < motion_.size(); ++k) {
    if (!is_force(run.input.probes[k])) {
      row.insert(row.end(), motion_[k].begin(), motion_[k].end());
      continue;
    }
    const Vec3 total = impulse(run, totals, k);
    double* memory = &run.force_memory[4 * k];
    Eigen::Map<Vec3> last(memory);
    const double passed = run.state.time - memory[3];
    const Vec3 mean = passed > 0 ? Vec3((total - last) / passed) : Vec3::Zero();
    for (int c = 0; c < 3; ++c) row.insert(row.end(), {mean[c], total[c]});
    last = total;
    memory[3] = run.state.time;
  }
  return row;
}

Vec3 Probes::impulse(const Prepared& run, const contact::ContactTotals& totals, std::size_t probe) const {
  const Probe& watched = run.input.probes[probe];
  if (watched.kind == Probe::Kind::wall) {
    const auto wall = std::ranges::find(run.model.walls, watched.where, &model::RigidWall::name);
    return totals.wall_impulse[static_cast<std::size_t>(wall - run.model.walls.begin())];
  }
  if (watched.kind == Probe::Kind::set) return reaction_impulse(run, probe);
  const auto pair = std::ranges::find(run.tracked, std::array{watched.where, watched.other});
  return totals.tracked_impulse[static_cast<std::size_t>(pair - run.tracked.begin())];
}

}  // namespace brunt::app
