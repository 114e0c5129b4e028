// SPDX-License-Identifier: Apache-2.0
#include "implicit/commit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "comm/exact_sum.hpp"
#include "implicit/balance.hpp"
#include "implicit/data/nodal.hpp"
#include "implicit/mortar/interface_forces.hpp"
#include "implicit/mortar/self_sides.hpp"
#include "model/curve.hpp"
#include "node_step.hpp"

namespace brunt::implicit {
namespace {

/// Effect of contact in one step, summed over the nodes that ranks own.
class ContactSums {
 public:
  /// If nodes move in straight lines in a step, a force at its end and the mean positions change the angular momentum
  /// by the moment of the force at these positions.
  void add(const NodeStep& step, const Vec3& mean_place) {
    const Vec3 moment = mean_place.cross(step.contact_impulse);
    sums_[normal].add(-(step.contact - step.friction).dot(step.travel));
    sums_[friction].add(-step.friction.dot(step.travel));
    for (std::size_t c = 0; c < 3; ++c) sums_[spin + c].add(moment[static_cast<int>(c)]);
    sums_[push].add(step.contact_impulse.norm());
  }
  /// Collective.
  void book(const comm::Communicator& ranks, const MortarContact& contact, ContactAccount& account) {
    std::array<double, terms> value{};
    comm::exact_sum(ranks, sums_, value);
    account.normal += value[normal];
    account.friction += value[friction];
    for (std::size_t c = 0; c < 3; ++c) account.spin[c] += value[spin + c];
    account.push += value[push];
    account.penetration = std::max(account.penetration, ranks.max(penetration(contact)));
  }

 private:
  enum Term : std::size_t { normal, friction, spin, push = spin + 3, terms };
  std::array<comm::ExactAccumulator, terms> sums_;
};

/// Forces of walls at the accepted iterate, on all nodes of this rank.
void find_wall_forces(const Scene& scene, Solver& solver) {
  Trial& trial = solver.trial;
  for (const WallNode& node : solver.walls.nodes) {
    const auto i = static_cast<std::size_t>(solver.unknowns.node[node.own]);
    const WallForces forces = forces_of(scene.model, solver.walls, node.own);
    put(forces.normal + forces.friction, trial.wall_force, i);
    put(forces.friction, trial.wall_friction, i);
  }
  share(solver.unknowns, trial.wall_force);
  share(solver.unknowns, trial.wall_friction);
}

/// Effect of walls in one step, summed over the nodes that ranks own.
class WallSums {
 public:
  void add(const NodeStep& step) {
    sums_[0].add(-(step.wall - step.wall_friction).dot(step.travel));
    sums_[1].add(-step.wall_friction.dot(step.travel));
  }
  /// Collective.
  void book(const comm::Communicator& ranks, WallAccount& account) {
    std::array<double, 2> value{};
    comm::exact_sum(ranks, sums_, value);
    account.normal += value[0];
    account.friction += value[1];
  }

 private:
  std::array<comm::ExactAccumulator, 2> sums_;
};

}  // namespace

void begin_step(const Scene& scene, Solver& solver, double dt, double time) {
  Trial& trial = solver.trial;
  model::State& state = scene.state;
  trial.rule = rule_of(solver.settings, dt);
  trial.time_before = state.time;
  trial.time = time;
  trial.ratios.clear();
  trial.stood.clear();
  for (std::size_t i = 0; i < state.nodes.size(); ++i) put(Eigen::Map<const Vec3>(state.nodes[i].v), trial.velocity, i);
  state.time = time;
  prescribe(scene, trial);
  if (solver.walls.any()) {
    begin_walls(scene.model, state, solver.unknowns, trial.time_before, time, solver.walls);
    fit_wall_springs(solver);
  }
  for (std::size_t k = 0; k < solver.unknowns.node.size(); ++k) {
    const auto i = static_cast<std::size_t>(solver.unknowns.node[k]);
    Vec3 travel = trial.rule.mass > 0 ? Vec3(dt * of(trial.velocity, i)) : Vec3(Vec3::Zero());
    // prescribed motion is applied in the first correction, which moves the adjacent nodes too
    if (const LocalIndex held = solver.held[i]; held != no_index)
      travel = nth(scene.model.supports.nodes, held).free * travel;
    put(of(state.displacement[i]) + travel, solver.u, k);
  }
  if (solver.bodies.any()) begin_bodies(scene, solver, false);
  trial.iterate = 0;
  const std::size_t first = 3 * solver.unknowns.node.size();
  for (std::size_t k = 0; k < solver.contact.own.size(); ++k)
    solver.u[first + k] = nth(solver.contact.z_before, solver.contact.own[k]);
}

void commit_step(const Scene& scene, Solver& solver) {
  if (solver.walls.any()) find_wall_forces(scene, solver);
  ContactSums sums;
  WallSums wall_sums;
  std::size_t next_owned = 0;
  begin_impulses(solver.bodies);
  for (std::size_t i = 0; i < scene.state.nodes.size(); ++i) {
    const NodeStep step = commit_node(scene, solver, i);
    const auto& own = solver.unknowns.node;
    if (next_owned == own.size() || static_cast<std::size_t>(own[next_owned]) != i) continue;
    if (solver.bodies.carries(next_owned))
      book_impulse(next_owned, step.internal_impulse + step.load_impulse + step.contact_impulse + step.wall_impulse,
                   solver);
    ++next_owned;
    if (solver.walls.any()) wall_sums.add(step);
    if (solver.contact.any())
      sums.add(step, of(scene.model.reference[i]) + of(scene.state.displacement[i]) - 0.5 * step.travel);
  }
  if (solver.contact.any()) {
    sums.book(scene.links.ranks, solver.contact, solver.contact_account);
    book_interfaces(solver.trial.rule.dt, end_shares(solver.trial.rule).of_impulse, solver.contact);
    keep_contact(solver.contact);
    tally(scene.links.ranks, solver.contact);
    choose_roles(scene.links.ranks, solver.contact);
  }
  if (solver.walls.any()) {
    wall_sums.book(scene.links.ranks, solver.walls.account);
    keep_walls(scene.links.ranks, scene.model, solver.trial.rule.dt, end_shares(solver.trial.rule).of_impulse,
               solver.walls);
  }
  if (solver.bodies.any()) commit_bodies(scene, solver);
  force::commit(solver.history, scene.state.history);
  model::State& state = scene.state;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    for (int c = 0; c < 3; ++c) state.nodes[i].x[c] = scene.model.reference[i][c] + state.displacement[i][c];
  for (std::size_t w = 0; w < scene.model.touching.walls.size(); ++w)
    if (scene.model.touching.walls[w].moves)
      state.wall_position[w] +=
          model::integral(scene.model.touching.walls[w].motion, solver.trial.time_before, solver.trial.time);
  state.time_before = solver.trial.time_before;
  state.dt = solver.trial.rule.dt;
  ++state.step;
}

void give_back(const Scene& scene, Solver& solver) {
  model::State& state = scene.state;
  state.time = solver.trial.time_before;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    Eigen::Map<Vec3>(state.nodes[i].v) = of(solver.trial.velocity, i);
    for (int c = 0; c < 3; ++c) state.nodes[i].x[c] = scene.model.reference[i][c] + state.displacement[i][c];
  }
}

}  // namespace brunt::implicit
