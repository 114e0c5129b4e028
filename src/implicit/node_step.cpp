// SPDX-License-Identifier: Apache-2.0
#include "node_step.hpp"

#include "implicit/data/nodal.hpp"

namespace brunt::implicit {
namespace {

/// Along constrained directions the supports supply the remainder of the balances of momentum and of energy.
void book_support(model::State& state, const Mat3& free, const NodeStep& step, bool moves, std::size_t i) {
  const Mat3 held = Mat3::Identity() - free;
  const Vec3 change = moves ? Vec3(step.mass * (step.after - step.before)) : Vec3(Vec3::Zero());
  const Vec3 impulse =
      held * (change - step.internal_impulse - step.load_impulse - step.contact_impulse - step.wall_impulse);
  const double kinetic = moves ? 0.5 * (held * change).dot(step.after + step.before) : 0.0;
  state.reaction_work[i] += kinetic - (held * (step.internal + step.load + step.contact + step.wall)).dot(step.travel);
  for (std::size_t c = 0; c < 3; ++c) state.reaction_impulse[3 * i + c] += impulse[static_cast<int>(c)];
}

/// Impulse in a step of the scheme by a force that changes from `before` to `now`. For hht the velocities contain its
/// accelerations, and thus forces at t_n and t_{n-1}; they are stored in `inertial`, which is updated to t_{n+1}.
Vec3 impulse_of(const Rule& rule, const Vec3& before, const Vec3& now, std::vector<double>& inertial, std::size_t i) {
  if (inertial.empty()) return 0.5 * rule.dt * (before + now);
  const Vec3 then = of(inertial, i), next = rule.now * now + rule.before * before;
  put(next, inertial, i);
  return rule.dt * ((1 - rule.gamma) * then + rule.gamma * next);
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

}  // namespace

EndShares end_shares(const Rule& rule) {
  const bool at_end = rule.mass > 0 && rule.beta == 0;
  const double of_work = at_end ? 1.0 : 0.5;
  return {of_work, rule.beta > 0 ? rule.gamma : of_work};
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
    const Mat3& free = scene.model.supports.nodes[h].free;
    if (trial.rule.mass > 0) step.after = free * step.after + trial.given_velocity[h];
    book_support(state, free, step, trial.rule.mass > 0, i);
  }
  const double* u = &trial.displacement[3 * i];  // stored, not a sum: a restart finds the same rows of contact
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

}  // namespace brunt::implicit
