// SPDX-License-Identifier: Apache-2.0
#include "time/ledger.hpp"

#include <algorithm>
#include <array>

#include "comm/exact_sum.hpp"
#include "contact/contact.hpp"
#include "model/alive.hpp"
#include "time/bodies_at_rest.hpp"
#include "time/rotations.hpp"

namespace brunt::time {
namespace {

enum Term {
  kinetic,
  element_work,
  load_work,
  damping_work,
  reaction_work,
  hourglass,
  bulk,
  eroded,   // by elements
  dropped,  // by nodes
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

Vec3 of(const Quad& q) {
  return {q[0], q[1], q[2]};
}

/// Effects of the step on a node besides forces; null if there are none.
struct NodeStep {
  const Vec3 *before = nullptr, *reaction = nullptr;
  bool is_dropped = false;  ///< left with its last element
};

/// Adds one node: accounts contain the work of whole steps, so half of the last impulse's work is subtracted.
void add_node(const model::Model& model, const model::State& state, const model::Scratch& scratch,
              const StepReport& step, const NodeStep& own, std::size_t i, Sums& sums) {
  const auto& [before, reaction, is_dropped] = own;
  const double dt_mean = step.dt_mean;
  const model::NodeLine& node = state.nodes[i];
  const Vec3 v = Eigen::Map<const Vec3>(node.v);
  const Vec3 element_impulse = dt_mean * of(scratch.force[i]);
  Vec3 impulse = element_impulse;
  sums[element_work].add(state.displacement[i][3] - 0.5 * v.dot(element_impulse));
  if (model.loaded()) {
    const Vec3 load = dt_mean * of(scratch.load[i]);
    impulse += load;
    sums[load_work].add(state.load_work[i] - 0.5 * v.dot(load));
    if (model.damped()) {
      const double half = is_dropped ? 0.0 : 0.5 * step.drag() * node.mass * v.dot(*before + v);
      sums[damping_work].add(state.damping_work[i] + half);
    }
    for (std::size_t c = 0; c < 3; ++c) sums[impulse_x + c].add(state.load_impulse[3 * i + c]);
  }
  if (model.supports.any) {
    sums[reaction_work].add(state.reaction_work[i] - (reaction ? 0.5 * v.dot(*reaction) : 0.0));
    for (std::size_t c = 0; c < 3; ++c) sums[impulse_x + c].add(state.reaction_impulse[3 * i + c]);
  }
  const Vec3 momentum_before = before ? Vec3(node.mass * *before) : Vec3(node.mass * v - impulse);
  if (is_dropped) {  // its energy is removed with it
    sums[dropped].add(0.5 * v.dot(momentum_before));
    for (std::size_t c = 0; c < 3; ++c) sums[impulse_x + c].add(-node.mass * v[static_cast<int>(c)]);
    return;
  }
  sums[kinetic].add(0.5 * v.dot(momentum_before));
  sums[mass_of_all].add(node.mass);
  for (std::size_t c = 0; c < 3; ++c) sums[momentum_x + c].add(node.mass * v[static_cast<int>(c)]);
  sums[momentum_scale].add(node.mass * v.norm());
}

/// The rotation of a node of shells, whose momentum is none of translation.
void add_rotation(const model::State& state, const model::Scratch& scratch, const StepReport& step, LocalIndex node,
                  bool is_dropped, Sums& sums) {
  const RotationEnergies now = rotation_energies(state, scratch, {step.dt, step.dt_mean, step.drag()}, node);
  sums[element_work].add(now.element_work);
  sums[load_work].add(now.load_work);
  sums[damping_work].add(now.damping_work);
  sums[reaction_work].add(now.reaction_work);
  sums[is_dropped ? dropped : kinetic].add(now.kinetic);
}

/// As for a node: half of the work of the last impulses is subtracted.
void add_body(const model::RigidBody& body, const model::BodyAccount& account, const model::BodyStep& now,
              const StepReport& step, Sums& sums) {
  const double mass = body.body.mass.mass;
  const auto half = [&](const Vec3& impulse, const Vec3& angular_impulse) {
    return 0.5 * (now.after.velocity.dot(impulse) + now.after.spin.dot(angular_impulse));
  };
  const Vec3 drag = step.drag() * mass * (now.before.velocity + now.after.velocity);
  const Vec3 drag_moment = step.drag() * (now.before.angular_momentum + now.after.angular_momentum);
  const double element_half = step.dt_mean * half(now.elements.force, now.elements.moment);
  const double load_half = step.dt_mean * half(now.loads.force, now.loads.moment);
  sums[element_work].add(account.element_work - element_half);
  sums[load_work].add(account.load_work - load_half);
  sums[damping_work].add(account.damping_work + half(drag, drag_moment));
  sums[reaction_work].add(account.reaction_work - now.late_work - half(now.reaction.force, now.reaction.moment) -
                          now.pivot_late);
  sums[kinetic].add(half(mass * now.before.velocity, now.before.angular_momentum));
  const Vec3 given = account.load_impulse + account.reaction_impulse;
  for (std::size_t c = 0; c < 3; ++c) {
    sums[impulse_x + c].add(given[static_cast<int>(c)]);
    sums[momentum_x + c].add(mass * now.after.velocity[static_cast<int>(c)]);
  }
  sums[mass_of_all].add(mass);
  sums[momentum_scale].add(mass * now.after.velocity.norm());
}

/// Every rank has all bodies; the root counts them.
void add_bodies(const model::Model& model, const model::State& state, const model::Scratch& scratch, const Links& links,
                const StepReport& step, Sums& sums) {
  if (!links.ranks.is_root()) return;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    add_body(model.bodies[b], state.body_accounts[b], scratch.bodies[b], step, sums);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const model::BodyJoint& joint = model.joints[j];
    if (joint.is_support() || (joint.body[0] != no_index && joint.body[1] != no_index)) continue;
    const double sign = joint.body[0] == no_index ? -1 : 1;  // what the ground gives to the body
    for (std::size_t c = 0; c < 3; ++c)
      sums[impulse_x + c].add(sign * state.joint_accounts[j].impulse[static_cast<int>(c)]);
  }
}

void add_nodes(const model::Model& model, const model::State& state, const model::Scratch& scratch,
               const StepReport& step, Sums& sums) {
  std::size_t next_constrained = 0;
  const std::vector<char> carried = nodes_of_bodies(model);
  for (const LocalIndex node : model.owned) {
    if (!carried.empty() && nth(carried, node)) continue;
    NodeStep own{.is_dropped = std::ranges::binary_search(state.living.dropped, node)};
    if (model.damped() || nth(state.nodes, node).deferred != 0.0) own.before = &nth(scratch.before, node);
    while (next_constrained < model.supports.nodes.size() && model.supports.nodes[next_constrained].node < node)
      ++next_constrained;
    if (next_constrained < model.supports.nodes.size() && model.supports.nodes[next_constrained].node == node)
      own.reaction = &scratch.reaction[next_constrained];
    add_node(model, state, scratch, step, own, static_cast<std::size_t>(node), sums);
    if (!state.rotations.empty() && nth(state.rotations, node).inertia > 0)
      add_rotation(state, scratch, step, node, own.is_dropped, sums);
  }
}

/// Removed elements: the total work of their forces, minus half of their last impulse's work as on nodes.
void add_removed(const model::State& state, const model::Scratch& scratch, Sums& sums) {
  for (std::size_t b = 0; b < state.alive.size(); ++b)
    for (std::size_t e = 0; e < state.alive[b].size(); ++e)
      if (state.alive[b][e] <= 0) sums[eroded].add(scratch.last_work[b][e] - state.element_work[b][e]);
}

void add_elements(const model::Model& model, const model::State& state, Sums& sums) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    const auto add = [&](const char* name, Term term) {
      const model::HistoryRange* range = block.find(name);
      if (!range) return;
      for (LocalIndex e = 0; e < block.count; ++e) {
        if (!model::lives(state, b, e)) continue;
        const std::ptrdiff_t row = std::ptrdiff_t{e / pack_width} * block.history_size + range->first;
        sums[term].add(nth(state.history[b], row * pack_width + e % pack_width));
      }
    };
    add("hourglass_energy", hourglass);
    add("bulk_energy", bulk);
  }
}

/// The work taken by contact and walls, without half of the last step's impulses.
void add_contact(const Links& links, const contact::Contact& contact, Ledger& result) {
  result.contact_totals = contact::collect(contact);
  const contact::ContactTotals& totals = result.contact_totals;
  contact::WorkSums late_half;
  contact::add_second_half(contact, late_half);
  std::array<comm::ExactAccumulator, 5> sums{late_half.contact, late_half.friction, late_half.walls, late_half.ties,
                                             late_half.driven};
  std::array<double, 5> half{};
  comm::exact_sum(links.ranks, sums, half);
  result.contact = totals.contact_work - half[0];
  result.friction = totals.friction_work - half[1];
  result.walls = totals.wall_work - half[2];
  result.ties = totals.tie_work - half[3];
  result.driven = totals.driven_work - half[4];
  for (const Vec3& impulse : totals.wall_impulse) result.impulse_given += impulse;
}

}  // namespace

Ledger ledger(const model::Model& model, const model::State& state, const model::Scratch& scratch, const Links& links,
              const contact::Contact* contact, const StepReport& step) {
  Sums sums;
  add_nodes(model, state, scratch, step, sums);
  add_bodies(model, state, scratch, links, step, sums);
  add_elements(model, state, sums);
  add_removed(state, scratch, sums);
  std::array<double, terms> value{};
  comm::exact_sum(links.ranks, sums, value);

  Ledger result;
  if (contact) add_contact(links, *contact, result);
  result.kinetic = value[kinetic];
  result.hourglass = value[hourglass];
  result.bulk = value[bulk];
  result.eroded = value[eroded] + value[dropped];
  result.internal = -value[element_work] - value[hourglass] - value[bulk] - value[eroded];
  result.damping = -value[damping_work];
  result.external = value[load_work] + value[reaction_work];
  result.mass = value[mass_of_all];
  result.momentum = {value[momentum_x], value[momentum_y], value[momentum_z]};
  result.impulse_given += Vec3{value[impulse_x], value[impulse_y], value[impulse_z]};
  result.momentum_scale = value[momentum_scale];
  return result;
}

}  // namespace brunt::time
