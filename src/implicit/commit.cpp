// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/commit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "brunt/comm/exact_sum.hpp"
#include "brunt/implicit/balance.hpp"
#include "brunt/implicit/interface_forces.hpp"
#include "brunt/model/curve.hpp"
#include "nodal.hpp"

namespace brunt::implicit {
namespace {

/// What happened to one node in the step.
struct NodeStep {
  Vec3 travel, before, after;  ///< u_{n+1} - u_n; velocities
  Vec3 internal, load;         ///< means of the forces at t_n and t_{n+1}, which do the work
  Vec3 contact, friction;      ///< likewise; friction is a part of contact
  Vec3 wall, wall_friction;    ///< likewise
  Vec3 contact_impulse, wall_impulse;
  Vec3 internal_impulse, load_impulse;  ///< what they add to momentum
  double mass = 0;
};

/// Along held directions supports give what is missing in the balance of momentum, and of energy.
void book_support(model::State& state, const Mat3& free, const NodeStep& step, bool moves, std::size_t i) {
  const Mat3 held = Mat3::Identity() - free;
  const Vec3 change = moves ? Vec3(step.mass * (step.after - step.before)) : Vec3(Vec3::Zero());
  const Vec3 impulse =
      held * (change - step.internal_impulse - step.load_impulse - step.contact_impulse - step.wall_impulse);
  const double kinetic = moves ? 0.5 * (held * change).dot(step.after + step.before) : 0.0;
  state.reaction_work[i] += kinetic - (held * (step.internal + step.load + step.contact + step.wall)).dot(step.travel);
  for (std::size_t c = 0; c < 3; ++c) state.reaction_impulse[3 * i + c] += impulse[static_cast<int>(c)];
}

/// What a force that goes from `before` to `now` adds to momentum in a step of the rule. hht adds to velocities what
/// its accelerations stand for, forces at t_n and t_{n-1} among them; they stand in `inertial`, which goes to t_{n+1}.
Vec3 impulse_of(const Rule& rule, const Vec3& before, const Vec3& now, std::vector<double>& inertial, std::size_t i) {
  if (inertial.empty()) return 0.5 * rule.dt * (before + now);
  const Vec3 then = of(inertial, i), next = rule.now * now + rule.before * before;
  put(next, inertial, i);
  return rule.dt * ((1 - rule.gamma) * then + rule.gamma * next);
}

/// How much of the forces of contact and walls at t_{n+1} is in the means of the step; the rest is of those at t_n.
struct EndShares {
  double of_work = 1, of_impulse = 1;
};

/// Contact acts as at the end of the step where the scheme says so, else as its mean does.
EndShares end_shares(const Rule& rule) {
  const bool at_end = rule.mass > 0 && rule.beta == 0;
  const double of_work = at_end ? 1.0 : 0.5;
  return {of_work, rule.beta > 0 ? rule.gamma : of_work};
}

void mean_contact(const Trial& trial, const Memory& memory, std::size_t i, NodeStep& step) {
  const EndShares end = end_shares(trial.rule);
  const auto mean = [&](const std::vector<double>& before, const std::vector<double>& now, double share) {
    return Vec3(share * of(now, i) + (1 - share) * of(before, i));
  };
  step.contact = mean(memory.contact_force, trial.contact_force, end.of_work);
  step.friction = mean(memory.friction_force, trial.friction_force, end.of_work);
  step.contact_impulse = trial.rule.dt * mean(memory.contact_force, trial.contact_force, end.of_impulse);
  step.wall = mean(memory.wall_force, trial.wall_force, end.of_work);
  step.wall_friction = mean(memory.wall_friction, trial.wall_friction, end.of_work);
  step.wall_impulse = trial.rule.dt * mean(memory.wall_force, trial.wall_force, end.of_impulse);
}

NodeStep commit_node(const Scene& scene, Solver& solver, std::size_t i) {
  model::State& state = scene.state;
  Trial& trial = solver.trial;
  Memory& memory = solver.memory;
  const Vec3 force = of(scene.scratch.force[i]);
  const Vec3 load = scene.scratch.load.empty() ? Vec3(Vec3::Zero()) : of(scene.scratch.load[i]);
  Vec3 acceleration = of(memory.acceleration, i);
  NodeStep step;
  step.travel = Vec3(&trial.displacement[3 * i]) - of(state.displacement[i]);
  step.before = of(trial.velocity, i);
  step.after = velocity_after(trial.rule, step.travel, step.before, acceleration);
  step.internal = 0.5 * (of(memory.internal_force, i) + force);
  step.load = 0.5 * (of(memory.load, i) + load);
  step.mass = state.nodes[i].mass;
  step.internal_impulse = impulse_of(trial.rule, of(memory.internal_force, i), force, memory.inertial_internal, i);
  step.load_impulse = impulse_of(trial.rule, of(memory.load, i), load, memory.inertial_load, i);
  mean_contact(trial, memory, i, step);
  if (const LocalIndex held = solver.held[i]; held != no_index) {
    const auto h = static_cast<std::size_t>(held);
    const Mat3& free = scene.model.constrained[h].free;
    if (trial.rule.mass > 0) step.after = free * step.after + trial.given_velocity[h];
    book_support(state, free, step, trial.rule.mass > 0, i);
  }
  const double* u = &trial.displacement[3 * i];  // itself, not a sum: a restart finds the same rows of contact there
  state.displacement[i] = Quad{u[0], u[1], u[2], state.displacement[i][3] + step.internal.dot(step.travel)};
  if (!state.load_work.empty()) {
    state.load_work[i] += step.load.dot(step.travel);
    for (std::size_t c = 0; c < 3; ++c) state.load_impulse[3 * i + c] += step.load_impulse[static_cast<int>(c)];
  }
  Eigen::Map<Vec3>(state.nodes[i].v) = step.after;
  put(force, memory.internal_force, i);
  if (!memory.load.empty()) put(load, memory.load, i);
  if (!memory.acceleration.empty()) put(acceleration, memory.acceleration, i);
  if (!memory.contact_force.empty()) {
    put(of(trial.contact_force, i), memory.contact_force, i);
    put(of(trial.friction_force, i), memory.friction_force, i);
  }
  if (!memory.wall_force.empty()) {
    put(of(trial.wall_force, i), memory.wall_force, i);
    put(of(trial.wall_friction, i), memory.wall_friction, i);
  }
  return step;
}

/// What contact did in one step, summed over the nodes that ranks own.
class ContactSums {
 public:
  /// With both ends of the step on a straight way, a force at its end and the mean place change the angular momentum by
  /// the moment of the force there.
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

/// What walls did in one step, summed over the nodes that ranks own.
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
  if (solver.walls.any()) begin_walls(scene.model, state, solver.unknowns, trial.time_before, time, solver.walls);
  for (std::size_t k = 0; k < solver.unknowns.node.size(); ++k) {
    const auto i = static_cast<std::size_t>(solver.unknowns.node[k]);
    Vec3 travel = trial.rule.mass > 0 ? Vec3(dt * of(trial.velocity, i)) : Vec3(Vec3::Zero());
    // what is given comes with the first correction, which moves the nodes around with it
    if (const LocalIndex held = solver.held[i]; held != no_index)
      travel = scene.model.constrained[static_cast<std::size_t>(held)].free * travel;
    put(of(state.displacement[i]) + travel, solver.u, k);
  }
  if (solver.bodies.any()) begin_bodies(scene, solver, false);
  trial.iterate = 0;
  const std::size_t first = 3 * solver.unknowns.node.size();
  for (std::size_t k = 0; k < solver.contact.own.size(); ++k)
    solver.u[first + k] = solver.contact.z_before[static_cast<std::size_t>(solver.contact.own[k])];
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
  for (std::size_t w = 0; w < scene.model.walls.size(); ++w)
    if (scene.model.walls[w].moves)
      state.wall_position[w] +=
          model::integral(scene.model.walls[w].motion, solver.trial.time_before, solver.trial.time);
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
