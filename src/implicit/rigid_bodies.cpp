// SPDX-License-Identifier: Apache-2.0
// Bodies at the start of a run and of a step, and their positions at an iterate.
#include "implicit/rigid_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "driven.hpp"
#include "implicit/data/nodal.hpp"
#include "implicit/solver.hpp"
#include "implicit/walls/wall_spring.hpp"
#include "model/curve.hpp"
#include "rigid/rotation.hpp"
#include "time/bodies.hpp"

namespace brunt::implicit {
namespace {

double radius_of_gyration(const rigid::MassProperties& mass) {
  return std::sqrt(mass.inertia.trace() / (2 * mass.mass));
}

void drive(const model::Model& model, const model::RigidBody& body, const rigid::BodyState& before, double from,
           double to, BodyTrial& trial) {
  const Vec3 spin = rigid::angular_velocity(body.body, before);
  trial.given_shift = trial.given_turn = trial.given_velocity = trial.given_spin = Vec3::Zero();
  for (std::size_t dof = 0; dof < body.drive.size(); ++dof) {
    if (!body.drive[dof]) continue;
    const auto c = static_cast<int>(dof % 3);
    const model::Drive& by = nth(model.supports.drives, *body.drive[dof]);
    const Given given = driven(by, dof < 3 ? before.velocity[c] : spin[c], from, to);
    (dof < 3 ? trial.given_shift : trial.given_turn)[c] = given.travel;
    (dof < 3 ? trial.given_velocity : trial.given_spin)[c] = given.velocity;
  }
}

/// Acceleration of gravity, common to all bodies [length/time^2].
Vec3 gravity_at(const model::Model& model, double time) {
  return model.has_gravity() ? Vec3(model::value_at(model.loads.gravity_curve, time) * model.loads.gravity)
                             : Vec3(Vec3::Zero());
}

/// The six unknowns of all bodies, sent by the root.
std::vector<double> told_to_all(const comm::Communicator& ranks, const RigidBodies& bodies, std::span<const double> u) {
  std::vector<double> values(body_unknowns * bodies.trial.size());
  std::vector<std::byte> bytes(values.size() * sizeof(double));
  if (bodies.rows_here) std::memcpy(bytes.data(), u.data() + bodies.first_here, bytes.size());
  ranks.broadcast(bytes);
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

void place(const model::RigidBody& body, const rigid::BodyState& before, const Rule& rule, double radius,
           BodyTrial& trial) {
  trial.orientation = (rigid::rotation_by((trial.arc - trial.base_arc) / radius) * trial.base).normalized();
  trial.turn = trial.orientation * before.orientation.conjugate();
  trial.turn_now = trial.orientation.toRotationMatrix();
  if (rule.mass > 0) trial.momentum = rigid::momentum_after(body.body, before, trial.turn, rule.dt);
}

}  // namespace

std::vector<GlobalIndex> RigidBodies::own_rows() const {
  std::vector<GlobalIndex> rows;
  for (std::size_t k = 0; rows_here && k < body_unknowns * trial.size(); ++k)
    rows.push_back(first + static_cast<GlobalIndex>(k));
  return rows;
}

RigidBodies make_bodies(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns,
                        GlobalIndex first, std::size_t first_here) {
  RigidBodies bodies;
  if (model.bodies.empty()) return bodies;
  bodies.first = first;
  bodies.first_here = first_here;
  bodies.rows_here = ranks.is_root();
  bodies.trial.resize(model.bodies.size());
  bodies.place.resize(unknowns.node.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const model::RigidBody& body = model.bodies[b];
    bodies.radius.push_back(radius_of_gyration(body.body.mass));
    std::size_t next_forced = 0;
    time::for_nodes(body, [&](std::size_t k, std::size_t i) {
      const auto own = std::ranges::lower_bound(unknowns.node, static_cast<LocalIndex>(i));
      while (next_forced < body.forced.size() && static_cast<std::size_t>(body.forced[next_forced]) < k) ++next_forced;
      if (own == unknowns.node.end() || *own != static_cast<LocalIndex>(i)) return;
      const bool forced = next_forced < body.forced.size() && static_cast<std::size_t>(body.forced[next_forced]) == k;
      nth(bodies.place, own - unknowns.node.begin()) = {static_cast<LocalIndex>(b), forced, body.arm[k]};
    });
  }
  return bodies;
}

void soften_walls(const comm::Communicator& ranks, const model::Model& model, Solver& solver) {
  RigidBodies& bodies = solver.bodies;
  if (!bodies.any() || !solver.walls.any()) return;
  std::vector<GlobalIndex> nodes(bodies.trial.size(), 0);
  for (const RigidBodies::Place& place : bodies.place)
    if (place.body != no_index) ++nth(nodes, place.body);
  ranks.sum(nodes);
  for (std::size_t b = 0; b < nodes.size(); ++b) {
    const double of_face = std::cbrt(static_cast<double>(nodes[b] * nodes[b]));
    bodies.at_walls.push_back(spring_at_walls * model.bodies[b].body.mass.mass / of_face);
  }
  for (WallNode& node : solver.walls.nodes) node.springs = bodies.carries(node.own);
  solver.memory.wall_stiffness.assign(static_cast<std::size_t>(model.nodes()), 0.0);
}

void fit_wall_springs(Solver& solver) {
  const bool statics = solver.settings.scheme == model::Scheme::statics;
  const double dt = solver.trial.rule.dt;
  for (const WallNode& node : solver.walls.nodes) {
    if (!node.springs || (!statics && node.behind_before > 0)) continue;
    const auto body = static_cast<std::size_t>(solver.bodies.place[node.own].body);
    nth(solver.memory.wall_stiffness, solver.unknowns.node[node.own]) =
        statics ? solver.support_stiffness : solver.bodies.at_walls[body] / (dt * dt);
  }
}

void begin_bodies(const Scene& scene, Solver& solver, bool still) {
  RigidBodies& bodies = solver.bodies;
  const Trial& step = solver.trial;
  for (std::size_t b = 0; b < bodies.trial.size(); ++b) {
    const model::RigidBody& body = scene.model.bodies[b];
    const rigid::BodyState& before = scene.state.bodies[b];
    BodyTrial& trial = bodies.trial[b];
    const double mass = body.body.mass.mass;
    drive(scene.model, body, before, step.time_before, step.time, trial);
    // a static run begins without loads: its first step applies those of t = 0
    const bool loaded = step.rule.mass > 0 || scene.state.step > 0;
    trial.gravity = mass * gravity_at(scene.model, step.time);
    trial.gravity_before = loaded ? Vec3(mass * gravity_at(scene.model, step.time_before)) : Vec3(Vec3::Zero());
    trial.turn_before = before.orientation.toRotationMatrix();
    trial.base = before.orientation;
    trial.base_arc.setZero();
    Vec3 shift = Vec3::Zero(), arc = Vec3::Zero();
    if (step.rule.mass > 0 && !still) {  // prescribed motion is applied in the first correction
      shift = body.support.free_shift * (step.rule.dt * before.velocity);
      arc = bodies.radius[b] * (body.support.free_turn * (step.rule.dt * rigid::angular_velocity(body.body, before)));
    }
    if (!bodies.rows_here) continue;
    Eigen::Map<Vec3>(solver.u.data() + bodies.first_here + body_unknowns * b) = before.displacement + shift;
    Eigen::Map<Vec3>(solver.u.data() + bodies.first_here + body_unknowns * b + 3) = arc;
  }
}

void place_bodies(const Scene& scene, Solver& solver, std::span<const double> u) {
  RigidBodies& bodies = solver.bodies;
  const std::vector<double> unknowns = told_to_all(scene.links.ranks, bodies, u);
  for (std::size_t b = 0; b < bodies.trial.size(); ++b) {
    const model::RigidBody& body = scene.model.bodies[b];
    BodyTrial& trial = bodies.trial[b];
    trial.displacement = Vec3(&unknowns[body_unknowns * b]);
    trial.arc = Vec3(&unknowns[body_unknowns * b + 3]);
    place(body, scene.state.bodies[b], solver.trial.rule, bodies.radius[b], trial);
    const Mat3 turned = trial.turn_now - Mat3::Identity();
    time::for_nodes(body, [&](std::size_t k, std::size_t i) {
      put(trial.displacement + turned * body.arm[k], solver.trial.displacement, i);
    });
  }
}

void show_bodies(const model::Model& model, const model::State& state, model::Scratch& scratch) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const rigid::Body& body = model.bodies[b].body;
    const rigid::BodyState& now = state.bodies[b];
    model::BodyStep& shown = scratch.bodies[b];
    shown.turn = now.orientation.toRotationMatrix();
    shown.inertia = rigid::inertia_now(body, now);
    shown.inverse = rigid::inverse_inertia_now(body, now);
    shown.centre = body.mass.centre + now.displacement;
    shown.before = {now.velocity, rigid::angular_velocity(body, now), now.angular_momentum};
    shown.predicted = shown.after = shown.before;
  }
}

}  // namespace brunt::implicit
