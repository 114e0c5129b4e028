// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/ledger.hpp"

#include <array>

#include "brunt/comm/exact_sum.hpp"

namespace brunt::implicit {
namespace {

enum Term {
  kinetic,
  element_work,
  load_work,
  reaction_work,
  mass_of_all,
  momentum_scale,
  momentum_x,
  momentum_y,
  momentum_z,
  impulse_x,
  impulse_y,
  impulse_z,
  terms
};
using Sums = std::array<comm::ExactAccumulator, terms>;

void add_node(const model::State& state, bool moves, std::size_t i, Sums& sums) {
  const model::NodeLine& node = state.nodes[i];
  const Vec3 v = Eigen::Map<const Vec3>(node.v);
  sums[mass_of_all].add(node.mass);
  sums[element_work].add(state.displacement[i][3]);
  if (!state.load_work.empty()) sums[load_work].add(state.load_work[i]);
  if (!state.reaction_work.empty()) sums[reaction_work].add(state.reaction_work[i]);
  for (std::size_t c = 0; c < 3; ++c) {
    if (!state.load_impulse.empty()) sums[impulse_x + c].add(state.load_impulse[3 * i + c]);
    if (!state.reaction_impulse.empty()) sums[impulse_x + c].add(state.reaction_impulse[3 * i + c]);
    if (moves) sums[momentum_x + c].add(node.mass * v[static_cast<int>(c)]);
  }
  if (!moves) return;
  sums[kinetic].add(0.5 * node.mass * v.squaredNorm());
  sums[momentum_scale].add(node.mass * v.norm());
}

}  // namespace

time::Ledger ledger(const Scene& scene, const Solver& solver) {
  const bool moves = solver.settings.scheme != model::Scheme::statics;
  Sums sums;
  for (const LocalIndex node : scene.model.owned) add_node(scene.state, moves, static_cast<std::size_t>(node), sums);
  std::array<double, terms> value{};
  comm::exact_sum(scene.links.ranks, sums, value);
  time::Ledger result;
  result.kinetic = value[kinetic];
  result.internal = -value[element_work];
  result.external = value[load_work] + value[reaction_work];
  result.contact = solver.contact_account.normal;
  result.friction = solver.contact_account.friction + solver.walls.account.friction;
  result.walls = solver.walls.account.normal;
  const ContactCounts& counts = solver.contact.counts;
  result.contact_totals.active = counts.active + pressed(scene.links.ranks, solver.walls);
  result.contact_totals.pairs = counts.pairs;
  result.contact_totals.penetration = solver.contact_account.penetration;
  result.contact_totals.spin = Vec3(solver.contact_account.spin);
  result.contact_totals.push = solver.contact_account.push;
  result.contact_totals.touching = counts.touching;
  result.mass = value[mass_of_all];
  result.momentum = {value[momentum_x], value[momentum_y], value[momentum_z]};
  result.impulse_given = {value[impulse_x], value[impulse_y], value[impulse_z]};
  for (std::size_t w = 0; w < scene.model.walls.size(); ++w) {
    result.contact_totals.wall_impulse.emplace_back(&solver.walls.impulse[3 * w]);
    result.impulse_given += result.contact_totals.wall_impulse.back();
  }
  result.momentum_scale = value[momentum_scale];
  return result;
}

}  // namespace brunt::implicit
