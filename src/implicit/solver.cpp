// SPDX-License-Identifier: Apache-2.0
#include "implicit/solver.hpp"

#include <cmath>

#include "comm/exact_sum.hpp"
#include "force/mass.hpp"
#include "implicit/balance.hpp"
#include "implicit/commit.hpp"
#include "implicit/owner.hpp"
#include "material/law.hpp"
#include "time/sum_forces.hpp"

namespace brunt::implicit {
namespace {

comm::LinearMethod method_of(model::LinearSolver linear) {
  return linear == model::LinearSolver::direct ? comm::LinearMethod::direct : comm::LinearMethod::mumps;
}

/// Largest modulus lambda + 2 mu times the mean spacing of nodes: about the stiffness of an element. Used for
/// constrained directions in the matrix, so that their entries have the order of the others in any units.
/// Returns that spacing.
double scale_supports(const Scene& scene, Solver& solver) {
  double modulus = 0, volume = 0;
  std::vector<double> volumes;
  const auto* reference = scene.model.reference.data();
  for (const model::ElementBlock& block : scene.model.blocks) {
    const material::ElasticModuli moduli = material::initial_moduli(block.law);
    modulus = std::max(modulus, moduli.lambda + 2 * moduli.mu);
    for (LocalIndex e = 0; e < block.count; ++e) volumes.push_back(force::element_volume(block, reference, e));
  }
  volume = comm::exact_sum(scene.links.ranks, volumes);
  const double spacing = std::cbrt(volume / static_cast<double>(scene.model.mesh.global_nodes));
  solver.support_stiffness = modulus * spacing;
  if (solver.support_stiffness > 0) return spacing;
  double mass = 0;  // of rigid bodies alone: their inertia in a step
  for (const model::RigidBody& body : scene.model.bodies) mass = std::max(mass, body.body.mass.mass);
  solver.support_stiffness = mass / (solver.settings.step * solver.settings.step);
  return spacing;
}

/// The parts of Memory that the scheme needs.
struct Remembered {
  bool load = false, acceleration = false, inertial = false;
};
Remembered remembered(const model::Model& model, const model::ImplicitSolver& settings) {
  const Rule rule = rule_of(settings, settings.step);
  return {model.loaded(), rule.beta > 0, rule.beta > 0 && rule.before > 0};
}

/// Forces at t = 0 and the resulting accelerations.
void start_memory(const Scene& scene, Solver& solver) {
  Memory& memory = solver.memory;
  const std::size_t n = scene.state.nodes.size();
  memory.internal_force.assign(3 * n, 0.0);
  const Remembered kept = remembered(scene.model, solver.settings);
  if (kept.load) memory.load.assign(3 * n, 0.0);
  const bool moves = solver.settings.scheme != model::Scheme::statics;
  if (kept.acceleration) memory.acceleration.assign(3 * n, 0.0);
  begin_step(scene, solver, solver.settings.step, scene.state.time);
  for (std::size_t k = 0; k < solver.unknowns.node.size(); ++k)  // at rest at the positions of the nodes
    for (std::size_t c = 0; c < 3; ++c)
      solver.u[3 * k + c] = nth(scene.state.displacement, solver.unknowns.node[k])[static_cast<int>(c)];
  if (solver.bodies.any()) begin_bodies(scene, solver, true);
  (void)find_forces(scene, solver, solver.u);
  for (std::size_t i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) {
      const std::size_t at = 3 * i + static_cast<std::size_t>(c);
      memory.internal_force[at] = scene.scratch.force[i][c];
      // a static run begins without loads: its first step applies also those of t = 0
      if (!memory.load.empty() && moves) memory.load[at] = scene.scratch.load[i][c];
    }
  for (std::size_t i = 0; kept.acceleration && i < n; ++i) {
    Vec3 force(&memory.internal_force[3 * i]);
    if (!memory.load.empty()) force += Vec3(&memory.load[3 * i]);
    if (const LocalIndex held = solver.held[i]; held != no_index)
      force = nth(scene.model.supports.nodes, held).free * force;
    Eigen::Map<Vec3>(&memory.acceleration[3 * i]) = force / scene.state.nodes[i].mass;
  }
  if (kept.inertial) {
    memory.inertial_internal = memory.internal_force;
    memory.inertial_load = memory.load;
  }
  give_back(scene, solver);
}

}  // namespace

void DeleteSolver::operator()(Solver* solver) const {
  delete solver;
}

Solver make_solver(const Scene& scene, const model::ImplicitSolver& settings) {
  const comm::Communicator& ranks = scene.links.ranks;
  const model::Model& model = scene.model;
  Unknowns unknowns = number_unknowns(ranks, model);
  Stiffness stiffness(ranks, model, unknowns);
  MortarContact contact = make_mortar(ranks, model, unknowns);
  std::vector<GlobalIndex> rows = unknowns.row;
  rows.insert(rows.end(), contact.own_rows.begin(), contact.own_rows.end());
  const GlobalIndex before_bodies = unknowns.total + static_cast<GlobalIndex>(contact.z_before.size());
  RigidBodies bodies = make_bodies(ranks, model, unknowns, before_bodies, rows.size());
  const std::vector<GlobalIndex> of_bodies = bodies.own_rows();
  rows.insert(rows.end(), of_bodies.begin(), of_bodies.end());
  const auto total = before_bodies + static_cast<GlobalIndex>(body_unknowns * bodies.trial.size());
  comm::LinearSystem system(ranks, method_of(settings.linear), total, rows);
  Solver solver{settings,
                std::move(unknowns),
                std::move(stiffness),
                std::move(contact),
                {},
                std::move(system),
                {},
                scene.state.history,
                {},
                {},
                0,
                {},
                {},
                {},
                {},
                {},
                std::move(bodies)};
  solver.u.resize(rows.size());
  solver.contact.keeps_gaps = solver.contact.mean_levers = settings.scheme == model::Scheme::contact_implicit;
  if (solver.contact.any()) {
    solver.trial.contact_force.assign(3 * scene.state.nodes.size(), 0.0);
    solver.trial.friction_force = solver.trial.contact_force;
    solver.memory.contact_force = solver.memory.friction_force = solver.trial.contact_force;
  }
  solver.held.assign(scene.state.nodes.size(), no_index);
  for (std::size_t k = 0; k < model.supports.nodes.size(); ++k)
    nth(solver.held, model.supports.nodes[k].node) = static_cast<LocalIndex>(k);
  solver.trial.displacement.assign(3 * scene.state.nodes.size(), 0.0);
  solver.trial.velocity.assign(3 * scene.state.nodes.size(), 0.0);
  const double spacing = scale_supports(scene, solver);
  solver.walls = make_walls(model, solver.unknowns, spacing);
  soften_walls(ranks, model, solver);
  if (solver.walls.any()) {
    solver.trial.wall_force.assign(3 * scene.state.nodes.size(), 0.0);
    solver.trial.wall_friction = solver.memory.wall_force = solver.memory.wall_friction = solver.trial.wall_force;
  }
  solver.driven.assign(2 * (model.touching.mortar.size() + model.touching.walls.size()), 0.0);
  start_memory(scene, solver);
  tally(ranks, solver.contact);
  show_bodies(model, scene.state, scene.scratch);
  return solver;
}

void after_restart(const Scene& scene, Solver& solver) {
  scale_supports(scene, solver);
  restore_contact(scene.links.ranks, scene.state, solver.contact);
  tally(scene.links.ranks, solver.contact);
  show_bodies(scene.model, scene.state, scene.scratch);
}

void add_arrays(const model::Model& model, Solver& solver, model::Registry& registry) {
  const auto nodal = [&](const char* name, std::vector<double>& values) {
    registry.arrays.push_back(
        {name, model::StateArray::Entity::node, -1, model.nodes(), 3, values.data(), 1, 3, 1, 0, true, true});
  };
  // the same arrays on every rank, even without nodes
  Memory& memory = solver.memory;
  const Remembered kept = remembered(model, solver.settings);
  nodal("internal_force", memory.internal_force);
  if (kept.load) nodal("load", memory.load);
  if (kept.inertial) nodal("inertial_internal", memory.inertial_internal);
  if (kept.inertial && kept.load) nodal("inertial_load", memory.inertial_load);
  if (kept.acceleration) nodal("acceleration", memory.acceleration);
  const auto global = [&](const char* name, double* values, std::size_t n) {
    const int width = static_cast<int>(n);
    if (width > 0)
      registry.arrays.push_back(
          {name, model::StateArray::Entity::global, -1, 1, width, values, 1, width, 1, 0, true, true});
  };
  if (!model.touching.mortar.empty()) {
    nodal("contact_force", memory.contact_force);
    nodal("friction_force", memory.friction_force);
    global("contact_account", &solver.contact_account.normal, contact_account_width);
    global("multipliers", solver.contact.z_before.data(), solver.contact.z_before.size());
    global("interface_impulses", solver.contact.impulses.data(), solver.contact.impulses.size());
    global("interface_forces", solver.contact.forces_before.data(), solver.contact.forces_before.size());
    global("contact_roles", solver.contact.roles_before.data(), solver.contact.roles_before.size());
    global("friction_tractions", solver.contact.traction_before.data(), solver.contact.traction_before.size());
  }
  if (!model.touching.walls.empty()) {
    nodal("wall_force", memory.wall_force);
    nodal("wall_friction", memory.wall_friction);
    global("wall_account", &solver.walls.account.normal, wall_account_width);
    global("wall_impulses", solver.walls.impulse.data(), solver.walls.impulse.size());
    global("wall_forces", solver.walls.force.data(), solver.walls.force.size());
    registry.arrays.push_back({"wall_penetration", model::StateArray::Entity::global, -1, 1, 1,
                               &solver.walls.penetration, 1, 1, 1, 0, true, false, false});
  }
  if (!model.touching.walls.empty() && !model.bodies.empty())
    registry.arrays.push_back({"wall_stiffness", model::StateArray::Entity::node, -1, model.nodes(), 1,
                               memory.wall_stiffness.data(), 1, 1, 1, 0, true, false, false});
  if (!solver.driven.empty())  // a diagnostic, not a state of the bodies
    registry.arrays.push_back({"driven_through", model::StateArray::Entity::global, -1, 1,
                               static_cast<int>(solver.driven.size()), solver.driven.data(), 1, 1, 1, 0, true, false});
  if (watches_stability(solver.settings))  // a diagnostic as well
    registry.arrays.push_back({"stability", model::StateArray::Entity::global, -1, 1, 2, &solver.stability.directions,
                               1, 2, 1, 0, true, false, false});
  registry.arrays.push_back({"step_length", model::StateArray::Entity::global, -1, 1, step_length_values,
                             &memory.length.level, 1, step_length_values, 1, 0, true, true});
  // lengths are multiples of these, which follow from run.end where the scene names none: those of the first run hold
  registry.arrays.push_back({"step_bounds", model::StateArray::Entity::global, -1, 1, model::step_bounds,
                             &solver.settings.step, 1, model::step_bounds, 1, 0, true, false, false});
}

}  // namespace brunt::implicit
