// SPDX-License-Identifier: Apache-2.0
// Rigid bodies in an accepted step: their motion, works and impulses.
#include <Eigen/Geometry>

#include "implicit/rigid_bodies.hpp"
#include "implicit/solver.hpp"
#include "rigid/rotation.hpp"
#include "time/bodies.hpp"

namespace brunt::implicit {
namespace {

constexpr std::size_t width = 6;  // impulses of force and moment

/// State at t_{n+1}; `free_momentum`: the angular momentum before the prescribed motion is applied.
rigid::BodyState moved(const model::RigidBody& body, const rigid::BodyState& before, const Rule& rule,
                       const BodyTrial& trial, Vec3& free_momentum) {
  rigid::BodyState after = before;
  after.displacement = trial.displacement;
  after.orientation = trial.orientation;
  const Vec3 shift = trial.displacement - before.displacement;
  if (rule.mass == 0) {
    after.velocity = shift / rule.dt;
    after.angular_momentum = rigid::angular_momentum_of(body.body, after, 2 / rule.dt * rigid::half_turn(trial.turn));
    return after;
  }
  after.velocity = body.support.free_shift * (2 / rule.dt * shift - before.velocity) + trial.given_velocity;
  after.angular_momentum = free_momentum = trial.momentum.momentum;
  if (!body.support.holds_turn) return after;
  const Mat3 inertia = rigid::inertia_now(body.body, after);
  after.angular_momentum =
      inertia * rigid::supported_spin(body.support.free_turn, inertia, free_momentum, trial.given_spin);
  return after;
}

double energy_of_spin(const rigid::Body& body, const rigid::BodyState& state, const Vec3& momentum) {
  rigid::BodyState turning = state;
  turning.angular_momentum = momentum;
  return 0.5 * momentum.dot(rigid::angular_velocity(body, turning));
}

/// Along constrained directions the supports supply the remainder of the balances of momentum and of energy.
void book_support(const model::RigidBody& body, const rigid::BodyState& before, const rigid::BodyState& after,
                  const Rule& rule, const BodyTrial& trial, const model::Wrench& impulse, const Vec3& free_momentum,
                  model::BodyAccount& account) {
  if (!body.support.any()) return;
  const bool moves = rule.mass > 0;
  const Mat3 held_shift = Mat3::Identity() - body.support.free_shift;
  const Mat3 held_turn = Mat3::Identity() - body.support.free_turn;
  const Vec3 shift = trial.displacement - before.displacement, half = rigid::half_turn(trial.turn);
  const Vec3 change = moves ? Vec3(body.body.mass.mass * (after.velocity - before.velocity)) : Vec3(Vec3::Zero());
  const Vec3 spun = moves ? Vec3(after.angular_momentum - before.angular_momentum) : Vec3(Vec3::Zero());
  const Vec3 freely = moves ? Vec3(free_momentum - before.angular_momentum) : Vec3(Vec3::Zero());
  account.reaction_impulse += held_shift * (change - impulse.force);
  account.reaction_angular_impulse += held_turn * (spun - impulse.moment);
  account.reaction_work += 0.5 * (held_shift * change).dot(after.velocity + (moves ? before.velocity : Vec3::Zero())) -
                           (held_shift * impulse.force).dot(shift) / rule.dt +
                           2 / rule.dt * half.dot(held_turn * (freely - impulse.moment));
  if (moves && body.support.holds_turn)
    account.reaction_work +=
        energy_of_spin(body.body, after, after.angular_momentum) - energy_of_spin(body.body, after, free_momentum);
}

}  // namespace

void begin_impulses(RigidBodies& bodies) {
  bodies.sums.assign(width * bodies.trial.size(), {});
}

void book_impulse(std::size_t own, const Vec3& impulse, Solver& solver) {
  if (impulse.isZero(0)) return;
  const RigidBodies::Place& place = solver.bodies.place[own];
  const auto b = static_cast<std::size_t>(place.body);
  const BodyTrial& trial = solver.bodies.trial[b];
  // with the mean arms the work of impulses equals that on the displacements of the nodes
  const Vec3 arm = 0.5 * (trial.turn_before * place.arm + trial.turn_now * place.arm);
  const Vec3 moment = arm.cross(impulse);
  comm::ExactAccumulator* sums = &solver.bodies.sums[width * b];
  for (int c = 0; c < 3; ++c) {
    sums[c].add(impulse[c]);
    sums[3 + c].add(moment[c]);
  }
}

void commit_bodies(const Scene& scene, Solver& solver) {
  RigidBodies& bodies = solver.bodies;
  const Rule& rule = solver.trial.rule;
  std::vector<double> values(bodies.sums.size());
  comm::exact_sum(scene.links.ranks, bodies.sums, values);
  for (std::size_t b = 0; b < bodies.trial.size(); ++b) {
    const model::RigidBody& body = scene.model.bodies[b];
    const BodyTrial& trial = bodies.trial[b];
    rigid::BodyState& state = scene.state.bodies[b];
    model::BodyAccount& account = scene.state.body_accounts[b];
    const Vec3 weight = 0.5 * (trial.gravity + trial.gravity_before);
    model::Wrench impulse{Vec3(&values[width * b]), Vec3(&values[width * b + 3])};
    impulse.force += rule.dt * weight;
    account.load_work += weight.dot(trial.displacement - state.displacement);
    account.load_impulse += rule.dt * weight;
    account.impulse += impulse.force;
    account.angular_impulse += impulse.moment;
    Vec3 free_momentum = Vec3::Zero();
    const rigid::BodyState after = moved(body, state, rule, trial, free_momentum);
    book_support(body, state, after, rule, trial, impulse, free_momentum, account);
    state = after;
    const Vec3 spin = rigid::angular_velocity(body.body, state);
    time::for_nodes(body, [&](std::size_t k, std::size_t i) {
      Eigen::Map<Vec3>(scene.state.nodes[i].v) = state.velocity + spin.cross(trial.turn_now * body.arm[k]);
    });
  }
  show_bodies(scene.model, scene.state, scene.scratch);
}

}  // namespace brunt::implicit
