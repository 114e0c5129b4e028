// SPDX-License-Identifier: Apache-2.0
#include "time/rotations.hpp"

#include <algorithm>
#include <cmath>

#include "force/mass.hpp"
#include "time/bodies_at_rest.hpp"
#include "time/driven_start.hpp"

namespace brunt::time {
namespace {

using model::RotationLine;

Vec3 of(const Quad& q) {
  return {q[0], q[1], q[2]};
}

inline double dot(const Quad& a, const Quad& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Quad with_inertia(const Quad& rate, double inertia) {
  return Quad{rate[0], rate[1], rate[2], inertia};
}

/// Cayley's vector over dt of a rotation by the angle rate * dt, of one component.
double cayley_rate(double rate, double dt) {
  return dt > 0 ? 2 * std::tan(0.5 * rate * dt) / dt : rate;
}

/// What drives give the rates of a supported node; nothing before t = 0.
Vec3 driven_rate(const model::Model& model, const model::State& state, const std::array<std::int32_t, 3>& drives,
                 const Vec3& before, const Interval& step) {
  Vec3 rate = Vec3::Zero();
  if (state.relaxation.under_way != 0) return rate;
  for (int c = 0; c < 3; ++c) {
    const std::int32_t drive = nth(drives, c);
    if (drive < 0) continue;
    const double given =
        driven_component(nth(model.supports.drives, drive), before[c], state.time, step.dt, step.dt_mean);
    rate[c] = cayley_rate(given, step.dt);
  }
  return rate;
}

/// The rate of a supported node: the impulse of its support, and its account.
void hold(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step,
          std::size_t k) {
  const contact::ConstrainedNode& held = model.rotation_supports.nodes[k];
  RotationLine& line = nth(state.rotations, held.node);
  model::RotationAccount& account = nth(state.rotation_accounts, held.node);
  Eigen::Map<Vec3> rate(line.rate);
  const Vec3 before = of(nth(scratch.rate_before, held.node));
  const Vec3 allowed = held.free * rate + driven_rate(model, state, model.rotation_supports.drive[k], before, step);
  const Vec3 impulse = (1 + step.drag) * line.inertia * (allowed - rate);
  rate = allowed;
  account.reaction_work += 0.5 * impulse.dot(before + rate);
  Eigen::Map<Vec3>(account.reaction_impulse) += impulse;
}

/// q <- cay(dt rate) q, renormalised.
void turn(RotationLine& line, double dt) {
  Eigen::Map<Eigen::Quaterniond> q(line.turn);
  const Vec3 half = 0.5 * dt * Vec3(line.rate);
  q = (Eigen::Quaterniond(1, half[0], half[1], half[2]) * q).normalized();
}

/// Supports of nodes that do not turn: in planes of symmetry, where parts are solid or rigid.
void drop_idle_supports(model::Model& model) {
  model::Supports kept;
  for (std::size_t k = 0; k < model.rotation_supports.nodes.size(); ++k) {
    if (!std::ranges::binary_search(model.turning, model.rotation_supports.nodes[k].node)) continue;
    kept.nodes.push_back(model.rotation_supports.nodes[k]);
    kept.drive.push_back(model.rotation_supports.drive[k]);
  }
  model.rotation_supports = std::move(kept);
}

}  // namespace

void size_rotations(const model::Model& model, model::State& state, model::Scratch& scratch) {
  const auto n = static_cast<std::size_t>(model.nodes());
  RotationLine start{};
  start.turn[3] = 1;
  state.rotations.assign(n, start);
  state.rotation_accounts.assign(n, {});
  scratch.moment.assign(n, Quad{});
  scratch.rate_before.assign(n, Quad{});
  scratch.moment_load.assign(model.loaded() ? n : 0, Quad{});
  scratch.moment_slots.assign(scratch.slots.size(), 0.0);
}

void weigh_rotations(model::Model& model, model::State& state, model::Scratch& scratch, Links& links) {
  force::lump_rotary_inertia(model, state, scratch);
  links.corner_moments.begin(scratch.moment_slots, 4);
  links.corner_moments.end(scratch.moment_slots, 4,
                           {reinterpret_cast<double*>(scratch.moment.data()), 4 * scratch.moment.size()}, 4);
  std::ranges::fill(scratch.moment_slots, 0.0);
  const std::vector<char> carried = nodes_of_bodies(model);
  model.turning.clear();
  for (LocalIndex i = 0; i < model.nodes(); ++i) {
    const double inertia = nth(scratch.moment, i)[0];
    nth(state.rotations, i).inertia = inertia;
    if (inertia > 0 && (carried.empty() || nth(carried, i) == 0)) model.turning.push_back(i);
  }
  drop_idle_supports(model);
}

void start_rotations(const model::Model& model, model::State& state, std::span<const Vec3> rate) {
  if (!rate.empty())
    for (const LocalIndex node : model.turning) Eigen::Map<Vec3>(nth(state.rotations, node).rate) = nth(rate, node);
  for (std::size_t k = 0; k < model.rotation_supports.nodes.size(); ++k) {
    const contact::ConstrainedNode& held = model.rotation_supports.nodes[k];
    Eigen::Map<Vec3> r(nth(state.rotations, held.node).rate);
    const Vec3 given = r;
    r = held.free * r;
    for (int c = 0; c < 3; ++c) {
      const std::int32_t drive = nth(model.rotation_supports.drive[k], c);
      if (drive >= 0) r[c] = driven_start(nth(model.supports.drives, drive), given[c]);
    }
  }
}

void advance_rotations(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step) {
  const bool loaded = model.loaded(), damped = model.damped();
  const double share = 1 / (1 + step.drag), kept = share * (1 - step.drag), half = 0.5 * step.dt_mean;
  const std::vector<contact::ConstrainedNode>& held = model.rotation_supports.nodes;
  std::size_t next_held = 0;
  for (const LocalIndex node : model.turning) {
    const auto i = static_cast<std::size_t>(node);
    RotationLine& line = state.rotations[i];
    model::RotationAccount& account = state.rotation_accounts[i];
    Quad moment = scratch.moment[i];
    if (loaded) moment += scratch.moment_load[i];
    const Quad before = line.rate_inertia();
    scratch.rate_before[i] = before;
    line.rate_inertia() = with_inertia(kept * before + (share * step.dt_mean / line.inertia) * moment, line.inertia);
    if (next_held < held.size() && held[next_held].node == node) hold(model, state, scratch, step, next_held++);
    const Quad twice_mean = before + line.rate_inertia();
    account.element_work += half * dot(twice_mean, scratch.moment[i]);
    if (loaded) account.load_work += half * dot(twice_mean, scratch.moment_load[i]);
    if (damped) account.damping_work -= 0.5 * step.drag * line.inertia * dot(twice_mean, twice_mean);
    turn(line, step.dt);
  }
}

RotationEnergies rotation_energies(const model::State& state, const model::Scratch& scratch, const Interval& step,
                                   LocalIndex node) {
  const model::RotationLine& line = nth(state.rotations, node);
  const model::RotationAccount& account = nth(state.rotation_accounts, node);
  const Vec3 after(line.rate), before = of(nth(scratch.rate_before, node));
  RotationEnergies energies;
  const Vec3 elements = step.dt_mean * of(nth(scratch.moment, node));
  const Vec3 drag = -step.drag * line.inertia * (before + after);
  Vec3 loads = Vec3::Zero();
  if (!scratch.moment_load.empty()) loads = step.dt_mean * of(nth(scratch.moment_load, node));
  const Vec3 reaction = line.inertia * (after - before) - elements - loads - drag;
  energies.kinetic = 0.5 * line.inertia * after.dot(before);
  energies.element_work = account.element_work - 0.5 * after.dot(elements);
  energies.load_work = account.load_work - 0.5 * after.dot(loads);
  energies.damping_work = account.damping_work - 0.5 * after.dot(drag);
  energies.reaction_work = account.reaction_work - 0.5 * after.dot(reaction);
  return energies;
}

RotationBalance balance_of_rotation(const model::State& state, const model::Scratch& scratch, double dt_mean,
                                    LocalIndex node) {
  const model::RotationLine& line = nth(state.rotations, node);
  const double share = nth(state.nodes, node).mass / line.inertia;
  const Vec3 net = line.inertia / dt_mean * (Vec3(line.rate) - of(nth(scratch.rate_before, node)));
  return {share * net.squaredNorm(), share * of(nth(scratch.moment_load, node)).squaredNorm()};
}

double kinetic_energy_of_rotation(const model::State& state, LocalIndex node) {
  const model::RotationLine& line = nth(state.rotations, node);
  return 0.5 * line.inertia * Eigen::Map<const Vec3>(line.rate).squaredNorm();
}

void stop_rotations(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state) {
  for (const LocalIndex node : model.turning) {
    model::RotationLine& line = nth(state.rotations, node);
    Eigen::Map<Vec3>(line.rate) =
        -0.5 * dt_mean / line.inertia * (of(nth(scratch.moment, node)) + of(nth(scratch.moment_load, node)));
  }
  for (const contact::ConstrainedNode& held : model.rotation_supports.nodes) {
    Eigen::Map<Vec3> rate(nth(state.rotations, held.node).rate);
    rate = held.free * rate;
  }
}

void begin_accounts_of_rotations(const model::Model& model, model::State& state) {
  for (const LocalIndex node : model.turning) {
    model::RotationAccount& account = nth(state.rotation_accounts, node);
    account = {.element_work = account.element_work, .load_work = -account.element_work};
  }
}

void add_rotations(model::State& state, LocalIndex nodes, std::vector<model::StateArray>& arrays) {
  const auto strided = [&](const char* name, double* first, int components, int stride) {
    arrays.push_back(
        {name, model::StateArray::Entity::node, -1, nodes, components, first, 1, stride, 1, 0, true, true});
  };
  constexpr int line = sizeof(RotationLine) / sizeof(double);
  auto* first = reinterpret_cast<double*>(state.rotations.data());
  strided("rotation_rate", first, 3, line);
  strided("rotation_turn", first + 4, 4, line);
  strided("rotation_accounts", reinterpret_cast<double*>(state.rotation_accounts.data()), model::rotation_account_width,
          model::rotation_account_width);
}

}  // namespace brunt::time
