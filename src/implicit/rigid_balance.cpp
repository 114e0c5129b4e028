// SPDX-License-Identifier: Apache-2.0
// Residual forces on rigid bodies.
#include <Eigen/Geometry>
#include <array>
#include <limits>

#include "core/cross_matrix.hpp"
#include "implicit/rigid_bodies.hpp"
#include "implicit/solver.hpp"
#include "rigid/rotation.hpp"

namespace brunt::implicit {
namespace {

/// Sums over a body's nodes: force, moment, derivative of the moment by a rotation.
constexpr std::size_t width = 6 + 9;

/// Inertia of the body in the balance of the step.
model::Wrench inertia_of(const model::RigidBody& body, const rigid::BodyState& before, const Rule& rule,
                         const BodyTrial& trial) {
  if (rule.mass == 0) return {};
  const Vec3 shift = trial.displacement - before.displacement;
  return {rule.mass * body.body.mass.mass * (shift - rule.dt * before.velocity),
          (trial.momentum.momentum - before.angular_momentum) / rule.dt};
}

/// Six equations, all as forces, and their contribution to the balance.
struct BodyResidual {
  Vec3 shift, turn;
  double given = 0, rounding = 0;  ///< squares [force^2]
};

BodyResidual residual_of(const model::RigidBody& body, const rigid::BodyState& before, const Solver& solver,
                         std::size_t b) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const BodyTrial& trial = solver.bodies.trial[b];
  const Rule& rule = solver.trial.rule;
  const double radius = solver.bodies.radius[b], stiffness = solver.support_stiffness;
  const rigid::Support& support = body.support;
  const model::Wrench inertia = inertia_of(body, before, rule, trial);
  const Vec3 gravity = rule.now * trial.gravity + rule.before * trial.gravity_before;
  const Vec3 moment = 1 / radius * (trial.left.moment + inertia.moment);
  const Vec3 travel = trial.displacement - before.displacement, turn = rigid::rotation_vector(trial.turn);
  BodyResidual result;
  result.shift = support.free_shift * (trial.left.force + inertia.force - gravity) +
                 stiffness * (travel - support.free_shift * travel - trial.given_shift);
  result.turn = support.free_turn * moment + stiffness * radius * (turn - support.free_turn * turn - trial.given_turn);
  // a free motion has momentum too, whose rounding errors remain in the residual
  const double rate = rule.mass * rule.dt;
  const Vec3 momentum = rate * body.body.mass.mass * before.velocity;
  const Vec3 spin = rate / radius * before.angular_momentum;
  result.given = inertia.force.squaredNorm() + (inertia.moment / radius).squaredNorm() + gravity.squaredNorm() +
                 momentum.squaredNorm() + spin.squaredNorm();
  // of displacements, which inertia multiplies; orientations are rounded too, as arcs of the radius
  const double left = rounding * rule.mass * body.body.mass.mass * (trial.displacement.norm() + radius);
  result.rounding = left * left;
  return result;
}

}  // namespace

void begin_left(RigidBodies& bodies) {
  bodies.sums.assign(width * bodies.trial.size(), {});
}

void leave_to_body(std::size_t own, const Vec3& left, Solver& solver) {
  if (left.isZero(0)) return;
  const RigidBodies::Place& place = solver.bodies.place[own];
  const auto b = static_cast<std::size_t>(place.body);
  const BodyTrial& trial = solver.bodies.trial[b];
  const bool moves = solver.trial.rule.mass > 0;
  const Vec3 now = trial.turn_now * place.arm;
  const Vec3 arm = moves ? Vec3(0.5 * (trial.turn_before * place.arm + now)) : now;
  const Vec3 moment = arm.cross(left);
  const Mat3 by_arm = (moves ? 0.5 : 1.0) * cross_matrix(left) * cross_matrix(now);
  comm::ExactAccumulator* sums = &solver.bodies.sums[width * b];
  for (int c = 0; c < 3; ++c) {
    sums[c].add(left[c]);
    sums[3 + c].add(moment[c]);
    for (int j = 0; j < 3; ++j) sums[6 + 3 * c + j].add(by_arm(c, j));
  }
}

void balance_bodies(const Scene& scene, Solver& solver, std::span<double> residual,
                    std::span<comm::ExactAccumulator, 3> sums) {
  RigidBodies& bodies = solver.bodies;
  std::vector<double> values(bodies.sums.size());
  comm::exact_sum(scene.links.ranks, bodies.sums, values);
  for (std::size_t b = 0; b < bodies.trial.size(); ++b) {
    const double* value = &values[width * b];
    BodyTrial& trial = bodies.trial[b];
    trial.left = {Vec3(value), Vec3(value + 3)};
    trial.by_arms = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(value + 6);
    if (!bodies.rows_here) continue;
    const BodyResidual left = residual_of(scene.model.bodies[b], scene.state.bodies[b], solver, b);
    sums[0].add(left.shift.squaredNorm() + left.turn.squaredNorm());
    sums[1].add(left.given);
    sums[2].add(left.rounding);
    Eigen::Map<Vec3>(residual.data() + bodies.first_here + body_unknowns * b) = left.shift;
    Eigen::Map<Vec3>(residual.data() + bodies.first_here + body_unknowns * b + 3) = left.turn;
  }
}

}  // namespace brunt::implicit
