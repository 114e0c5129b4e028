// SPDX-License-Identifier: Apache-2.0
#include "implicit/balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comm/exact_sum.hpp"
#include "implicit/data/measure.hpp"
#include "implicit/data/nodal.hpp"
#include "time/sum_forces.hpp"

namespace brunt::implicit {
namespace {

/// Forces on a node except those of contact and supports.
struct NodeForces {
  Vec3 inertia = Vec3::Zero(), now, before;  ///< m M (u - u*), now F_{n+1}, before F_n
};

NodeForces forces_on(const Scene& scene, const Solver& solver, std::size_t own) {
  const auto i = static_cast<std::size_t>(solver.unknowns.node[own]);
  const Trial& trial = solver.trial;
  const Rule& rule = trial.rule;
  const Quad& u_before = scene.state.displacement[i];
  NodeForces forces;
  forces.now = rule.now * of(scene.scratch.force[i]);
  if (!scene.scratch.load.empty()) forces.now += rule.now * of(scene.scratch.load[i]);
  forces.before = rule.before * (of(solver.memory.internal_force, i) + of(solver.memory.load, i));
  const Vec3 travel = Vec3(&trial.displacement[3 * i]) - of(u_before);
  const Vec3 free = free_travel(rule, of(trial.velocity, i), of(solver.memory.acceleration, i));
  if (!solver.bodies.carries(own)) forces.inertia = rule.mass * scene.state.nodes[i].mass * (travel - free);
  return forces;
}

/// Residual at a node (place in Unknowns::node) with constraints by supports and walls.
Vec3 supported(const Scene& scene, Solver& solver, std::size_t own, Vec3 left) {
  const auto i = static_cast<std::size_t>(solver.unknowns.node[own]);
  const Vec3 travel = Vec3(&solver.trial.displacement[3 * i]) - of(scene.state.displacement[i]);
  Mat3 free = Mat3::Identity();
  Vec3 by_supports = Vec3::Zero();
  if (const LocalIndex held = solver.held[i]; held != no_index) {
    const auto h = static_cast<std::size_t>(held);
    free = scene.model.supports.nodes[h].free;
    by_supports = solver.support_stiffness * ((travel - free * travel) - solver.trial.given[h]);
    left = free * left;
  }
  if (solver.walls.any()) {
    WallQuestion question;
    question.free = free;
    question.left = left;
    question.travel = travel;
    question.friction_before = of(solver.memory.wall_friction, i);
    question.stiffness = solver.bodies.carries(own) ? solver.memory.wall_stiffness[i] : solver.support_stiffness;
    const Vec3 x = Eigen::Map<const Vec3>(scene.state.nodes[i].x);
    if (const WallAction* action = meet_walls(scene.model, x, own, question, solver.walls)) left = action->left;
  }
  return left + by_supports;
}

/// Square of the residual due to rounding at a node: the rounding of positions strains the elements, and that of
/// displacements enters inertia.
double rounding_at(const Scene& scene, const Solver& solver, std::size_t i) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of u, of u_n, of their difference, of u*
  const model::NodeLine& node = scene.state.nodes[i];
  const double by_place = solver.support_stiffness * Eigen::Map<const Vec3>(node.x).norm();
  const double by_travel = solver.trial.rule.mass * node.mass * Vec3(&solver.trial.displacement[3 * i]).norm();
  const double left = rounding * (by_place + by_travel);
  return left * left;
}

std::span<const double> own_multipliers(const Solver& solver, std::span<const double> u) {
  return u.subspan(3 * solver.unknowns.node.size(), solver.contact.own.size());
}

/// Contact at the iterate, on all nodes of this rank.
void find_contact_forces(const Scene& scene, Solver& solver, std::span<const double> own_z) {
  const Measure timed(solver.work.contact_seconds);
  Trial& trial = solver.trial;
  MortarContact& contact = solver.contact;
  gather_contact(scene.links.ranks, scene.state, own_z, contact);
  const Iterate first = scene.state.step == 0 ? Iterate::first_of_run : Iterate::first_of_step;
  find_contact(scene.links.ranks, contact, trial.iterate == 0 ? first : Iterate::later);
  ++trial.iterate;
  for (std::size_t k = 0; k < contact.nodes.lasting; ++k) {
    if (contact.nodes.own[k] == no_index) continue;
    const auto i = static_cast<std::size_t>(contact.nodes.source[k].index);
    put(contact.nodes.force[k], trial.contact_force, i);
    put(contact.nodes.friction_force[k], trial.friction_force, i);
  }
  share(solver.unknowns, trial.contact_force);
  share(solver.unknowns, trial.friction_force);
}

/// For the nodes of contact that this rank owns: directions left free by supports and walls. Walls act on nodes of
/// rigid bodies by springs, which are no constraints.
std::vector<Mat3> movable_now(const Solver& solver) {
  const ContactNodes& nodes = solver.contact.nodes;
  std::vector<Mat3> movable(nodes.free.begin(), nodes.free.begin() + static_cast<std::ptrdiff_t>(nodes.lasting));
  for (std::size_t k = 0; k < nodes.lasting && solver.walls.any(); ++k) {
    if (nodes.own[k] == no_index || solver.bodies.carries(static_cast<std::size_t>(nodes.own[k]))) continue;
    if (const WallAction* action = action_of(solver.walls, static_cast<std::size_t>(nodes.own[k])))
      movable[k] = action->free;
  }
  return movable;
}

/// Residual at a node (place in Unknowns::node) without supports and walls.
Vec3 left_at(const Scene& scene, const Solver& solver, std::size_t own) {
  const auto i = static_cast<std::size_t>(solver.unknowns.node[own]);
  const NodeForces forces = forces_on(scene, solver, own);
  return forces.inertia - forces.now - forces.before - of(solver.trial.contact_force, i);
}

/// Removes the wall constraints of nodes that ties constrain to positions in the same walls; determines the active
/// walls first. Collective.
void let_ties_carry(const Scene& scene, Solver& solver) {
  const auto tied = [](const Interface& face) { return face.pair.tied; };
  if (!solver.walls.any() || std::ranges::none_of(solver.contact.interfaces, tied)) return;
  for (WallNode& node : solver.walls.nodes) node.tied.setZero();
  const ContactNodes& nodes = solver.contact.nodes;
  for (std::size_t k = 0; k < nodes.lasting; ++k)
    if (const LocalIndex own = nodes.own[k]; own != no_index) {
      const auto at = static_cast<std::size_t>(own);
      (void)supported(scene, solver, at, left_at(scene, solver, at));
    }
  const std::vector<Mat3> carried = carried_by_ties(scene.links.ranks, movable_now(solver), solver.contact);
  for (std::size_t k = 0; k < carried.size(); ++k)
    if (nodes.own[k] != no_index && !carried[k].isZero(0))
      nth(solver.walls.nodes, nth(solver.walls.node_of, nodes.own[k])).tied = carried[k];
}

}  // namespace

bool find_element_forces(const Scene& scene, Solver& solver, std::span<const double> displacement) {
  const double over_dt = 1 / solver.trial.rule.dt;
  for (std::size_t i = 0; i < scene.state.nodes.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      scene.state.nodes[i].x[c] = scene.model.reference[i][c] + displacement[3 * i + c];
      scene.state.nodes[i].v[c] = over_dt * (displacement[3 * i + c] - scene.state.displacement[i][c]);
    }
  const force::Motion motion{scene.state.nodes, solver.trial.rule.dt, false};
  const force::ElementReport report =
      force::trial_forces(scene.model, motion, scene.state.history, solver.history, scene.scratch);
  if (scene.links.ranks.any(report.inverted_block >= 0)) return false;
  time::sum_forces(scene.model, scene.state, scene.scratch, scene.links);
  return true;
}

bool find_forces(const Scene& scene, Solver& solver, std::span<const double> u) {
  Trial& trial = solver.trial;
  for (std::size_t k = 0; k < solver.unknowns.node.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      trial.displacement[3 * static_cast<std::size_t>(solver.unknowns.node[k]) + c] = u[3 * k + c];
  share(solver.unknowns, trial.displacement);
  if (solver.bodies.any()) place_bodies(scene, solver, u);
  if (!find_element_forces(scene, solver, trial.displacement)) return false;
  if (solver.contact.any()) find_contact_forces(scene, solver, own_multipliers(solver, u));
  return true;
}

void balance(const Scene& scene, Solver& solver, std::span<double> residual) {
  Trial& trial = solver.trial;
  let_ties_carry(scene, solver);
  std::array<comm::ExactAccumulator, 3> sums;
  begin_left(solver.bodies);
  for (std::size_t k = 0; k < solver.unknowns.node.size(); ++k) {
    const auto i = static_cast<std::size_t>(solver.unknowns.node[k]);
    const NodeForces forces = forces_on(scene, solver, k);
    const Vec3 contact = of(trial.contact_force, i);
    Vec3 left = forces.inertia - forces.now - forces.before - contact;
    // a free motion has momentum too, whose rounding errors remain in the residual
    const bool carried = solver.bodies.carries(k);
    const double momentum = carried ? 0.0 : trial.rule.mass * trial.rule.dt * scene.state.nodes[i].mass;
    sums[1].add(forces.inertia.squaredNorm() + forces.now.squaredNorm() + forces.before.squaredNorm());
    sums[1].add(contact.squaredNorm());
    sums[1].add(momentum * momentum * of(trial.velocity, i).squaredNorm());
    left = supported(scene, solver, k, left);
    if (carried) {
      leave_to_body(k, left, solver);
      left.setZero();
    }
    if (!carried || solver.bodies.place[k].forced) sums[2].add(rounding_at(scene, solver, i));
    sums[0].add(left.squaredNorm());
    for (std::size_t c = 0; c < 3; ++c) residual[3 * k + c] = left[static_cast<int>(c)];
  }
  const std::span<double> multipliers = residual.subspan(3 * solver.unknowns.node.size(), solver.contact.own.size());
  if (solver.contact.any()) {
    if (solver.walls.any() ||
        (solver.contact.may_imply && std::ranges::any_of(solver.contact.interfaces, &Interface::presses)))
      leave_out_redundant(scene.links.ranks, movable_now(solver), solver.contact);  // else as at the start
    multiplier_residuals(solver.contact, multipliers);
  }
  for (const double left : multipliers) sums[0].add(left * left);
  if (solver.bodies.any()) balance_bodies(scene, solver, residual, sums);
  std::array<double, 3> value{};
  comm::exact_sum(scene.links.ranks, sums, value);
  trial.balance = {std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2])};
}

}  // namespace brunt::implicit
