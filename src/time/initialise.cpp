// SPDX-License-Identifier: Apache-2.0
#include "time/initialise.hpp"

#include <algorithm>

#include "force/internal.hpp"
#include "force/mass.hpp"
#include "time/bodies.hpp"
#include "time/driven_start.hpp"
#include "time/joints.hpp"
#include "time/rotations.hpp"

namespace brunt::time {
namespace {

void size_histories(model::Model& model, model::State& state) {
  for (model::ElementBlock& block : model.blocks) {
    block.history.clear();
    block.history_size = 0;
    const std::vector<element::HistoryField> fields = force::history_fields(block);
    for (const element::HistoryField& field : fields) {
      block.history.push_back({field.name, block.history_size, field.components});
      block.history_size += field.components;
    }
    AlignedVector<double>& history = state.history.emplace_back();
    history.reserve(static_cast<std::size_t>(block.batches()) * static_cast<std::size_t>(block.history_size) *
                    pack_width);
    for (LocalIndex batch = 0; batch < block.batches(); ++batch)
      for (const element::HistoryField& field : fields)
        history.insert(history.end(), static_cast<std::size_t>(field.components) * pack_width, field.start);
  }
}

void size_nodes(const model::Model& model, model::State& state, model::Scratch& scratch) {
  const auto n = static_cast<std::size_t>(model.nodes());
  state.displacement.assign(n, Quad{});
  state.nodes.assign(n, model::NodeLine{});
  scratch.force.resize(n);
  const bool may_drop =
      std::ranges::any_of(model.losses.removals, [](const model::Removal& removal) { return !removal.keeps_nodes; }) ||
      std::ranges::any_of(
          model.blocks, [](const model::ElementBlock& block) { return block.erosion && !block.erosion->keeps_nodes; });
  const bool keeps_before = !model.deferred.empty() || model.damped() || !model.bodies.empty() || may_drop;
  scratch.before.assign(keeps_before ? n : 0, Vec3::Zero());
  scratch.reaction.resize(model.supports.nodes.size());
  std::size_t slots = 0;
  for (const model::ElementBlock& block : model.blocks) slots += block.border.values.size();
  scratch.slots.assign(4 * slots, 0.0);
  if (model.loaded()) {
    state.load_work.assign(n, 0.0);
    state.load_impulse.assign(3 * n, 0.0);
    scratch.load.resize(n);
  }
  if (model.damped()) state.damping_work.assign(n, 0.0);
  if (model.turns()) size_rotations(model, state, scratch);
  if (model.supports.any) {
    state.reaction_work.assign(n, 0.0);
    state.reaction_impulse.assign(3 * n, 0.0);
    if (model.touching.contact.pairs.any_acts() || !model.touching.walls.empty())
      scratch.contact_impulse.assign(n, Vec3::Zero());
  }
  state.bodies.assign(model.bodies.size(), {});
  state.body_accounts.assign(model.bodies.size(), {});
  scratch.bodies.assign(model.bodies.size(), {});
  if (model.relaxes) {
    state.held_force.assign(3 * n, 0.0);
    state.held_wrench.assign(model.bodies.size(), {});
  }
  state.wall_position.assign(model.touching.walls.size(), 0.0);
  if (model.between_parts.booked)
    for (const model::ElementBlock& block : model.blocks)
      state.interface_work.emplace_back(static_cast<std::size_t>(block.count), 0.0);
}

/// Flags, works and kept forces of blocks that may lose elements.
void size_removals(const model::Model& model, model::State& state, model::Scratch& scratch) {
  if (!model.loses_elements()) return;
  const std::size_t n = model.blocks.size();
  for (auto* arrays : {&state.alive, &state.element_work, &scratch.last_work}) arrays->resize(n);
  for (auto* arrays : {&scratch.element_force, &scratch.element_power, &scratch.element_bounds}) arrays->resize(n);
  for (std::size_t b = 0; b < n; ++b) {
    if (model.losses.erodes[b] == 0) continue;
    const auto count = static_cast<std::size_t>(model.blocks[b].count);
    const auto batches = static_cast<std::size_t>(model.blocks[b].batches());
    state.alive[b].assign(count, 1.0);
    state.element_work[b].assign(count, 0.0);
    scratch.last_work[b].assign(count, 0.0);
    scratch.element_force[b].assign(
        batches * static_cast<std::size_t>(model.blocks[b].corner_components() * model.blocks[b].corners()) *
            pack_width,
        0.0);
    scratch.element_power[b].assign(batches * pack_width, 0.0);
    if (model.blocks[b].erosion) scratch.element_bounds[b].assign(2 * batches * pack_width, 0.0);
  }
}

model::StateArray nodal(const std::string& name, std::vector<double>& values, int components, LocalIndex nodes) {
  return {name, model::StateArray::Entity::node, -1, nodes, components, values.data(), 1, components, 1, 0, true, true};
}

model::StateArray global(const std::string& name, double* values, int components) {
  return {name, model::StateArray::Entity::global, -1, 1, components, values, 1, components, 1, 0, true, true};
}

/// Registers each quantity of the bodies, one row for each body.
void add_bodies(model::State& state, std::vector<model::StateArray>& arrays) {
  const auto rows = [&](const char* name, double* first, int components, std::size_t stride) {
    arrays.push_back({name, model::StateArray::Entity::global, -1, static_cast<LocalIndex>(state.bodies.size()),
                      components, first, 1, static_cast<int>(stride / sizeof(double)), 1, 0, true, true});
  };
  rigid::BodyState& first = state.bodies.front();
  rows("body_displacement", first.displacement.data(), 3, sizeof first);
  rows("body_orientation", first.orientation.coeffs().data(), 4, sizeof first);
  rows("body_velocity", first.velocity.data(), 3, sizeof first);
  rows("body_angular_momentum", first.angular_momentum.data(), 3, sizeof first);
  model::BodyAccount& account = state.body_accounts.front();
  rows("body_accounts", &account.element_work, model::body_account_width, sizeof account);
  if (!state.joint_accounts.empty())
    arrays.push_back({"joint_accounts", model::StateArray::Entity::global, -1,
                      static_cast<LocalIndex>(state.joint_accounts.size()), model::joint_account_width,
                      state.joint_accounts.front().impulse.data(), 1, model::joint_account_width, 1, 0, true, true});
  if (!state.held_wrench.empty())
    rows("body_held", state.held_wrench.front().force.data(), 6, sizeof state.held_wrench.front());
}

}  // namespace

void initialise(model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                std::span<const Vec3> velocity, std::span<const Vec3> rate) {
  // decided over all ranks: a registry must list the same arrays everywhere
  model.supports.any = links.ranks.any(!model.supports.nodes.empty());
  model.between_parts.booked = links.ranks.any(!model.between_parts.nodes.empty());
  model.block_size.clear();
  for (const model::ElementBlock& block : model.blocks)
    model.block_size.push_back(links.ranks.sum(GlobalIndex{block.count}));
  model.losses.erodes.assign(model.blocks.size(), 0);
  for (const model::Removal& removal : model.losses.removals)
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
      if (links.ranks.any(!removal.elements[b].empty())) model.losses.erodes[b] = 1;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (model.blocks[b].erosion) model.losses.erodes[b] = 1;
  size_histories(model, state);
  size_removals(model, state, scratch);
  size_nodes(model, state, scratch);
  model.owned.clear();
  for (LocalIndex i = 0; i < model.nodes(); ++i)
    if (nth(model.mesh.owner, i) == links.ranks.rank()) model.owned.push_back(i);

  const auto sum_masses = [&](force::Lumped elements) {
    force::lump_mass(model, state, scratch, elements);
    links.corner_forces.begin(scratch.slots, 4);
    links.corner_forces.end(scratch.slots, 4,
                            {reinterpret_cast<double*>(scratch.force.data()), 4 * scratch.force.size()}, 4);
  };
  if (!model.bodies.empty()) {
    sum_masses(force::Lumped::deformable);
    if (model.turns()) weigh_rotations(model, state, scratch, links);
    weigh_bodies(links.ranks, model, {scratch.force.data(), scratch.force.size()}, state.rotations);
    place_joints(model, state, scratch);
  }
  sum_masses(force::Lumped::all);
  std::ranges::fill(scratch.slots, 0.0);  // those of rigid elements remain zero, since these have no forces
  for (std::size_t i = 0; i < state.nodes.size(); ++i) state.nodes[i].mass = scratch.force[i][0];
  if (model.turns() && model.bodies.empty()) weigh_rotations(model, state, scratch, links);
  for (const LocalIndex node : model.deferred) nth(state.nodes, node).deferred = 1.0;
  for (const model::RigidBody& body : model.bodies)
    for (const LocalIndex node : body.nodes) nth(state.nodes, node).deferred = 1.0;
  if (model.relaxes)
    state.relaxation.under_way = 1;
  else
    start_velocities(model, state, velocity, rate);
  update_positions(model, state);
}

void start_velocities(const model::Model& model, model::State& state, std::span<const Vec3> velocity,
                      std::span<const Vec3> rate) {
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    for (int c = 0; c < 3; ++c) state.nodes[i].v[c] = velocity[i][c];
  for (std::size_t k = 0; k < model.supports.nodes.size(); ++k) {
    const contact::ConstrainedNode& constrained = model.supports.nodes[k];
    Eigen::Map<Vec3> v(nth(state.nodes, constrained.node).v);
    const Vec3 given = v;
    v = constrained.free * v;
    for (int c = 0; c < 3; ++c) {
      const std::int32_t drive = nth(model.supports.drive[k], c);
      if (drive >= 0) v[c] = driven_start(nth(model.supports.drives, drive), given[c]);
    }
  }
  if (!state.rotations.empty()) start_rotations(model, state, rate);
  start_bodies(model, state);
}

void update_positions(const model::Model& model, model::State& state) {
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    for (int c = 0; c < 3; ++c) state.nodes[i].x[c] = model.reference[i][c] + state.displacement[i][c];
}

model::Registry state_registry(const model::Model& model, model::State& state) {
  model::Registry registry;
  const mesh::LocalMesh& mesh = model.mesh;
  registry.global_nodes = mesh.global_nodes;
  registry.node_gid = mesh.node_gid;
  for (const LocalIndex node : model.owned) {
    registry.owned_node.push_back(node);
    registry.owned_node_gid.push_back(nth(mesh.node_gid, node));
  }
  const LocalIndex n = model.nodes();
  auto& arrays = registry.arrays;
  arrays.push_back(global("time", &state.time, 1));
  arrays.push_back(global("time_before", &state.time_before, 1));
  arrays.push_back(global("dt", &state.dt, 1));
  arrays.push_back(global("step", &state.step, 1));
  arrays.push_back(global("rate_now", &state.rate_now, 1));
  arrays.push_back(global("rate_before", &state.rate_before, 1));
  if (!state.wall_position.empty())
    arrays.push_back(global("wall_position", state.wall_position.data(), static_cast<int>(state.wall_position.size())));
  const auto strided = [&](const char* name, double* first, int components, int stride) {
    arrays.push_back({name, model::StateArray::Entity::node, -1, n, components, first, 1, stride, 1, 0, true, true});
  };
  if (!state.bodies.empty()) add_bodies(state, arrays);
  auto* u = reinterpret_cast<double*>(state.displacement.data());
  constexpr int line = sizeof(model::NodeLine) / sizeof(double);
  strided("displacement", u, 3, 4);
  strided("internal_work", u + 3, 1, 4);
  strided("velocity", reinterpret_cast<double*>(state.nodes.data()) + 4, 3, line);
  if (model.loaded()) {
    arrays.push_back(nodal("load_work", state.load_work, 1, n));
    arrays.push_back(nodal("load_impulse", state.load_impulse, 3, n));
  }
  if (model.damped()) arrays.push_back(nodal("damping_work", state.damping_work, 1, n));
  if (model.supports.any) {
    arrays.push_back(nodal("reaction_work", state.reaction_work, 1, n));
    arrays.push_back(nodal("reaction_impulse", state.reaction_impulse, 3, n));
  }
  if (!state.rotations.empty()) add_rotations(state, n, arrays);
  if (model.relaxes) {
    static_assert(sizeof(model::Relaxation) == model::relaxation_values * sizeof(double));
    arrays.push_back(global("relaxation", &state.relaxation.under_way, model::relaxation_values));
    arrays.push_back(nodal("held_force", state.held_force, 3, n));
  }
  GlobalIndex first = 0;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    registry.element_gid.emplace_back(block.gid);
    registry.block_first.push_back(first);
    registry.block_count.push_back(model.block_size[b]);
    first += model.block_size[b];
    const auto by_element = [&](const char* name, std::vector<double>& values) {
      arrays.push_back({"block/" + block.part + name, model::StateArray::Entity::element, static_cast<std::int32_t>(b),
                        block.count, 1, values.data(), 1, 1, 1, 0, true, true});
    };
    if (model.between_parts.booked) by_element("/interface_work", state.interface_work[b]);
    if (b < model.losses.erodes.size() && model.losses.erodes[b] != 0) {
      by_element("/alive", state.alive[b]);
      by_element("/work", state.element_work[b]);
    }
    for (const model::HistoryRange& range : block.history)
      arrays.push_back({"block/" + block.part + "/" + range.name, model::StateArray::Entity::element,
                        static_cast<std::int32_t>(b), block.count, range.components,
                        state.history[b].data() + range.first * pack_width, pack_width, block.history_size * pack_width,
                        pack_width, 1, true, true});
  }
  return registry;
}

}  // namespace brunt::time
