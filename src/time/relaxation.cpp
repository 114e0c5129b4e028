// SPDX-License-Identifier: Apache-2.0
#include "time/relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "comm/exact_sum.hpp"
#include "core/error.hpp"
#include "force/element_work.hpp"
#include "force/watched.hpp"
#include "model/hash.hpp"
#include "time/bodies_at_rest.hpp"
#include "time/initialise.hpp"
#include "time/rotations.hpp"

namespace brunt::time {
namespace {

double kinetic_energy(const model::Model& model, const model::State& state, const Links& links) {
  std::array<comm::ExactAccumulator, 1> sum;
  const std::vector<char> carried = nodes_of_bodies(model);
  for (const LocalIndex node : model.owned) {
    if (!carried.empty() && nth(carried, node) != 0) continue;
    const model::NodeLine& line = nth(state.nodes, node);
    sum[0].add(0.5 * line.mass * Eigen::Map<const Vec3>(line.v).squaredNorm());
    if (model.turns()) sum[0].add(kinetic_energy_of_rotation(state, node));
  }
  std::array<double, 1> energy{};
  comm::exact_sum(links.ranks, sum, energy);
  return energy[0] + kinetic_energy_of_bodies(model, state);
}

/// Norm of the unbalanced forces over the norm of the loads, and the strain energy of the bodies.
struct Balance {
  double residual = 0, stored = 0;
};

/// After a step of `dt_mean`: the residual of deferred nodes includes contact and supports, that of others only forces
/// and loads.
Balance balance(const model::Model& model, const model::State& state, const model::Scratch& scratch, const Links& links,
                double dt_mean) {
  enum { left, given, work, terms };
  std::array<comm::ExactAccumulator, terms> sums;
  const std::vector<char> carried = nodes_of_bodies(model);
  for (const LocalIndex node : model.owned) {
    const auto i = static_cast<std::size_t>(node);
    if (!carried.empty() && carried[i] != 0) continue;
    const model::NodeLine& line = state.nodes[i];
    const Quad &f = scratch.force[i], &p = scratch.load[i];
    Vec3 net(f[0] + p[0], f[1] + p[1], f[2] + p[2]);
    if (line.deferred != 0) net = line.mass / dt_mean * (Eigen::Map<const Vec3>(line.v) - scratch.before[i]);
    sums[left].add(net.squaredNorm());
    sums[given].add(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    sums[work].add(-state.displacement[i][3]);
    if (state.rotations.empty() || !(state.rotations[i].inertia > 0)) continue;
    const RotationBalance turning = balance_of_rotation(state, scratch, dt_mean, node);
    sums[left].add(turning.left);
    sums[given].add(turning.given);
    sums[work].add(-state.rotation_accounts[i].element_work);
  }
  std::array<double, terms> value{};
  comm::exact_sum(links.ranks, sums, value);
  const BodyBalance bodies = balance_of_bodies(model, scratch, dt_mean);
  value[left] += bodies.left;
  value[given] += bodies.given;
  for (const model::BodyAccount& account : state.body_accounts) value[work] -= account.element_work;
  return {value[given] > 0 ? std::sqrt(value[left] / value[given]) : 0.0, value[work]};
}

/// Model::Relaxation::under_way: the action of the next step after its forces are computed.
constexpr double move = 1, stop = 2, stop_at_rest = 3;

Vec3 of(const Quad& q) {
  return {q[0], q[1], q[2]};
}

/// Brings the nodes to rest at x_n: their velocity half a step before is minus the one that the forces produce until
/// then, so that half a step later it has the opposite sign. (Zero at n - 1/2 would excite the highest modes, and a
/// first step of half the length would halve the impulses of contact.)
void stop_nodes(const model::Model& model, model::State& state, const model::Scratch& scratch, double dt_mean) {
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    model::NodeLine& node = state.nodes[i];
    Eigen::Map<Vec3>(node.v) =
        -0.5 * dt_mean / node.mass * (of(scratch.force[i]) + of(scratch.load[i]) + Vec3(&state.held_force[3 * i]));
  }
  for (const contact::ConstrainedNode& constrained : model.supports.nodes) {
    Eigen::Map<Vec3> v(nth(state.nodes, constrained.node).v);
    v = constrained.free * v;
  }
  stop_rotations(model, scratch, dt_mean, state);
  stop_bodies(model, scratch, dt_mean, state);
}

/// Constraint forces on the deferred nodes in the last step: all changes of their velocities except by forces and
/// loads.
void keep_held_forces(const model::Model& model, model::State& state, const model::Scratch& scratch, double dt_mean) {
  std::ranges::fill(state.held_force, 0.0);
  for (const LocalIndex deferred : model.deferred) {
    const auto i = static_cast<std::size_t>(deferred);
    const model::NodeLine& node = state.nodes[i];
    const Vec3 change = Eigen::Map<const Vec3>(node.v) - scratch.before[i];
    Eigen::Map<Vec3>(&state.held_force[3 * i]) =
        node.mass / dt_mean * change - of(scratch.force[i]) - of(scratch.load[i]);
  }
  keep_held_wrenches(model, scratch, dt_mean, state);
}

/// The work of element forces on the displacements of the nodes, by the trapezoidal rule: half a step on each side of
/// t_n. The accounts of `advance` (impulse times mean velocity) refer to velocities that a stop removes.
class WorkAlongTheWay {
 public:
  WorkAlongTheWay(const model::Model& model, model::State& state, const model::Scratch& scratch)
      : model_(model), state_(state), scratch_(scratch) {}

  /// after: the half step after t_n, otherwise the one before it.
  void add(double half_step, bool after) {
    for (std::size_t i = 0; i < state_.nodes.size(); ++i)
      state_.displacement[i][3] += half_step * Eigen::Map<const Vec3>(state_.nodes[i].v).dot(of(scratch_.force[i]));
    for (const LocalIndex node : model_.turning)
      nth(state_.rotation_accounts, node).element_work +=
          half_step * Eigen::Map<const Vec3>(nth(state_.rotations, node).rate).dot(of(nth(scratch_.moment, node)));
    add_work_on_bodies(model_, scratch_, half_step, after, state_);
    force::add_interface_work(model_, state_, scratch_, half_step);
    force::add_element_work(model_, state_, scratch_, half_step);
  }
  void keep() {
    nodes_.resize(state_.nodes.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) nodes_[i] = state_.displacement[i][3];
    rotations_ = state_.rotation_accounts;
    bodies_.clear();
    for (const model::BodyAccount& account : state_.body_accounts) bodies_.push_back(account.element_work);
    interface_ = state_.interface_work;
    elements_ = state_.element_work;
  }
  void give_back() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) state_.displacement[i][3] = nodes_[i];
    std::ranges::copy(rotations_, state_.rotation_accounts.begin());
    for (std::size_t b = 0; b < bodies_.size(); ++b) state_.body_accounts[b].element_work = bodies_[b];
    for (std::size_t b = 0; b < interface_.size(); ++b)
      std::ranges::copy(interface_[b], state_.interface_work[b].begin());
    for (std::size_t b = 0; b < elements_.size(); ++b) std::ranges::copy(elements_[b], state_.element_work[b].begin());
  }

 private:
  const model::Model& model_;
  model::State& state_;
  const model::Scratch& scratch_;
  std::vector<double> nodes_, bodies_;
  std::vector<model::RotationAccount> rotations_;
  std::vector<std::vector<double>> interface_, elements_;
};

/// Number of steps after its peak at which an oscillation ends. The highest modes have periods of 3 steps and more:
/// their peaks, which alternate while a slow oscillation still grows, must not end it. A stop removes the current
/// kinetic energy of a mode, which vanishes if the number of steps is a quarter of its period. The number therefore
/// varies without a fixed order (5 to 13): a fixed short sequence can lock in and delay convergence by an order of
/// magnitude.
double patience(const model::Relaxation& phase) {
  constexpr std::uint64_t least = 5, kinds = 9;
  return static_cast<double>(least + model::mix_bits(static_cast<std::uint64_t>(phase.swing_start)) % kinds);
}

/// At the end of an oscillation: its information on the static state, and the next stage of the loads. True at rest.
bool judge_swing(const Balance& now, double tolerance, model::Relaxation& phase) {
  const double length = phase.steps - phase.swing_start;
  const bool small = phase.peak <= tolerance * tolerance * now.stored || phase.peak == 0;
  const bool loaded = phase.stage >= relaxation_stages;
  if (!small || !loaded) {
    phase.longest_swing = std::max(phase.longest_swing, length);
    phase.quiet_since = phase.steps;
  }
  phase.residual = now.residual;
  const bool quiet = phase.steps - phase.quiet_since >= phase.longest_swing || phase.peak == 0;
  if (!loaded) ++phase.stage;
  phase.swing_start = phase.steps;
  phase.peak = 0;
  phase.peak_step = phase.steps;
  return loaded && small && quiet && now.residual <= tolerance;
}

}  // namespace

RelaxationStep relax(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                     contact::Contact* contact, const StepControl& control, const RelaxationSettings& settings) {
  model::Relaxation& phase = state.relaxation;
  RelaxationStep result;
  result.step = evaluate(model, state, scratch, links, control);
  if (result.step.stop) return result;
  result.step.alpha = 0;  // mass damping by `damping` applies to the run only
  const double share = phase.stage / relaxation_stages;
  if (share < 1) {
    for (Quad& load : scratch.load) load *= share;
    for (Quad& moment : scratch.moment_load) moment *= share;
    scale_body_loads(share, scratch);
  }
  WorkAlongTheWay work(model, state, scratch);
  work.add(0.5 * state.dt, false);
  // not earlier: stresses follow the velocities of the previous step, which were needed until here
  result.at_rest = phase.under_way == stop_at_rest;
  if (result.at_rest) return result;
  if (phase.under_way == stop) stop_nodes(model, state, scratch, result.step.dt_mean);
  phase.under_way = move;
  work.keep();
  advance(model, state, scratch, links, contact, result.step);
  work.give_back();
  work.add(0.5 * result.step.dt, true);
  state.time = state.step = 0;
  state.time_before = -1;
  ++phase.steps;

  const double kinetic = kinetic_energy(model, state, links);
  if (!std::isfinite(kinetic)) throw GuardError("relaxation: the motion is not a number");
  if (kinetic > phase.peak) {
    phase.peak = kinetic;
    phase.peak_step = phase.steps;
  }
  result.stopped = phase.steps - phase.peak_step >= patience(phase);
  if (!result.stopped) return result;
  keep_held_forces(model, state, scratch, result.step.dt_mean);
  const Balance now = balance(model, state, scratch, links, result.step.dt_mean);
  phase.under_way = judge_swing(now, settings.tolerance, phase) ? stop_at_rest : stop;
  return result;
}

void begin_run(const model::Model& model, model::State& state, std::span<const Vec3> velocity,
               std::span<const Vec3> rate) {
  state.relaxation.under_way = 0;
  start_velocities(model, state, velocity, rate);
  state.time = state.dt = state.step = 0;
  state.time_before = -1;
  state.rate_now = state.rate_before = 0;
  for (std::size_t i = 0; i < state.load_work.size(); ++i) state.load_work[i] = -state.displacement[i][3];
  for (auto* account : {&state.load_impulse, &state.damping_work, &state.reaction_work, &state.reaction_impulse})
    std::ranges::fill(*account, 0.0);
  begin_accounts_of_rotations(model, state);
  begin_accounts_of_bodies(state);
}

}  // namespace brunt::time
