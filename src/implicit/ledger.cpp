// SPDX-License-Identifier: Apache-2.0
#include "implicit/ledger.hpp"

#include <array>

#include "comm/exact_sum.hpp"
#include "time/bodies_at_rest.hpp"

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

/// Works and impulses of forces on a node.
void add_forces(const model::State& state, std::size_t i, Sums& sums) {
  sums[element_work].add(state.displacement[i][3]);
  if (!state.load_work.empty()) sums[load_work].add(state.load_work[i]);
  if (!state.reaction_work.empty()) sums[reaction_work].add(state.reaction_work[i]);
  for (std::size_t c = 0; c < 3; ++c) {
    if (!state.load_impulse.empty()) sums[impulse_x + c].add(state.load_impulse[3 * i + c]);
    if (!state.reaction_impulse.empty()) sums[impulse_x + c].add(state.reaction_impulse[3 * i + c]);
  }
}

/// A node or a body with its velocity.
void add_motion(double mass, const Vec3& v, bool moves, Sums& sums) {
  sums[mass_of_all].add(mass);
  if (!moves) return;
  for (std::size_t c = 0; c < 3; ++c) sums[momentum_x + c].add(mass * v[static_cast<int>(c)]);
  sums[kinetic].add(0.5 * mass * v.squaredNorm());
  sums[momentum_scale].add(mass * v.norm());
}

/// The work of forces on its nodes is counted for the nodes. Every rank has all bodies; the root counts them.
void add_body(const model::RigidBody& body, const rigid::BodyState& state, const model::BodyAccount& account,
              bool moves, Sums& sums) {
  add_motion(body.body.mass.mass, state.velocity, moves, sums);
  if (moves) sums[kinetic].add(0.5 * state.angular_momentum.dot(rigid::angular_velocity(body.body, state)));
  sums[load_work].add(account.load_work);
  sums[reaction_work].add(account.reaction_work);
  for (std::size_t c = 0; c < 3; ++c) {
    sums[impulse_x + c].add(account.load_impulse[static_cast<int>(c)]);
    sums[impulse_x + c].add(account.reaction_impulse[static_cast<int>(c)]);
  }
}

void add_all(const Scene& scene, bool moves, Sums& sums) {
  const model::State& state = scene.state;
  const std::vector<char> carried = time::nodes_of_bodies(scene.model);
  for (const LocalIndex node : scene.model.owned) {
    const auto i = static_cast<std::size_t>(node);
    add_forces(state, i, sums);
    if (carried.empty() || carried[i] == 0)
      add_motion(state.nodes[i].mass, Eigen::Map<const Vec3>(state.nodes[i].v), moves, sums);
  }
  for (std::size_t b = 0; scene.links.ranks.is_root() && b < scene.model.bodies.size(); ++b)
    add_body(scene.model.bodies[b], state.bodies[b], state.body_accounts[b], moves, sums);
}

}  // namespace

time::Ledger ledger(const Scene& scene, const Solver& solver) {
  const bool moves = solver.settings.scheme != model::Scheme::statics;
  Sums sums;
  add_all(scene, moves, sums);
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
  result.contact_totals.penetration = std::max(solver.contact_account.penetration, solver.walls.penetration);
  result.contact_totals.spin = Vec3(solver.contact_account.spin);
  result.contact_totals.push = solver.contact_account.push;
  result.contact_totals.touching = counts.touching;
  result.mass = value[mass_of_all];
  result.momentum = {value[momentum_x], value[momentum_y], value[momentum_z]};
  result.impulse_given = {value[impulse_x], value[impulse_y], value[impulse_z]};
  for (std::size_t w = 0; w < scene.model.touching.walls.size(); ++w) {
    result.contact_totals.wall_impulse.emplace_back(&solver.walls.impulse[3 * w]);
    result.impulse_given += result.contact_totals.wall_impulse.back();
  }
  result.momentum_scale = value[momentum_scale];
  return result;
}

}  // namespace brunt::implicit
