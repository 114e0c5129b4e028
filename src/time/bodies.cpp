// SPDX-License-Identifier: Apache-2.0
#include "time/bodies.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "comm/exact_sum.hpp"
#include "model/curve.hpp"
#include "time/joints.hpp"

namespace brunt::time {
namespace {

using model::BodyStep;
using model::RigidBody;

Vec3 of(const Quad& q) {
  return {q[0], q[1], q[2]};
}

constexpr std::size_t wrench_width = 6;

/// Adds a force at `arm` from the centre.
void add_force(const Vec3& force, const Vec3& arm, comm::ExactAccumulator* sums) {
  const Vec3 moment = arm.cross(force);
  for (std::size_t c = 0; c < 3; ++c) {
    sums[c].add(force[static_cast<int>(c)]);
    sums[3 + c].add(moment[static_cast<int>(c)]);
  }
}

void add_moment(const Quad& moment, comm::ExactAccumulator* sums) {
  for (int c = 0; c < 3; ++c) sums[3 + c].add(moment[c]);
}

model::Wrench wrench_of(const double* sums) {
  return {Vec3(sums), Vec3(sums + 3)};
}

/// Gravity at t_n [length/time^2].
Vec3 gravity_at(const model::Model& model, double time) {
  return model.has_gravity() ? Vec3(model::value_at(model.loads.gravity_curve, time) * model.loads.gravity)
                             : Vec3(Vec3::Zero());
}

/// Prescribed velocities of the body by drives for the next half step.
void drive(const model::Model& model, const model::State& state, const RigidBody& body, const Interval& step,
           BodyStep& now) {
  now.given_velocity.setZero();
  now.given_spin.setZero();
  if (state.relaxation.under_way != 0) return;  // before t = 0
  for (std::size_t dof = 0; dof < body.drive.size(); ++dof) {
    if (!body.drive[dof]) continue;
    const auto c = static_cast<int>(dof % 3);
    const model::Drive& drive = nth(model.supports.drives, *body.drive[dof]);
    const double before = dof < 3 ? now.before.velocity[c] : now.before.spin[c];
    (dof < 3 ? now.given_velocity : now.given_spin)[c] =
        driven_component(drive, before, state.time, step.dt, step.dt_mean);
  }
}

/// Applies the prescribed velocity along constrained directions, with the required impulses.
void support(const RigidBody& body, const Interval& step, BodyStep& now) {
  now.reaction = {};
  if (!body.support.any()) return;
  const double mass = (1 + step.drag) * body.body.mass.mass;
  const Vec3 velocity = body.support.free_shift * now.predicted.velocity + now.given_velocity;
  now.reaction.force = mass * (velocity - now.predicted.velocity);
  now.predicted.velocity = velocity;
  if (!body.support.holds_turn) return;
  const Vec3 spin =
      rigid::supported_spin(body.support.free_turn, now.inertia, now.predicted.angular_momentum, now.given_spin);
  const Vec3 momentum = now.inertia * spin;
  now.reaction.moment = (1 + step.drag) * (momentum - now.predicted.angular_momentum);
  now.predicted.angular_momentum = momentum;
}

void predict(const model::Model& model, const model::State& state, const RigidBody& body,
             const rigid::BodyState& moving, const Interval& step, BodyStep& now) {
  now.turn = moving.orientation.toRotationMatrix();
  now.inertia = rigid::inertia_now(body.body, moving);
  now.inverse = rigid::inverse_inertia_now(body.body, moving);
  now.centre = body.body.mass.centre + moving.displacement;
  now.before = {moving.velocity, now.inverse * moving.angular_momentum, moving.angular_momentum};
  const double share = 1 / (1 + step.drag), kept = share * (1 - step.drag), dt = share * step.dt_mean;
  const Vec3 force = now.elements.force + now.loads.force, moment = now.elements.moment + now.loads.moment;
  now.predicted.velocity = kept * now.before.velocity + dt / body.body.mass.mass * force;
  now.predicted.angular_momentum = kept * now.before.angular_momentum + dt * moment;
  drive(model, state, body, step, now);
  support(body, step, now);
  now.predicted.spin = now.inverse * now.predicted.angular_momentum;
  now.after = now.predicted;
}

/// The components of a velocity as bounds of contact::VelocitySpan: the largest, then minus the smallest.
template <class Velocity>
void widen(const Velocity& velocity, double* bounds) {
  for (int c = 0; c < 3; ++c) {
    const double v = std::isfinite(velocity[c]) ? velocity[c] : std::numeric_limits<double>::infinity();
    bounds[c] = std::max(bounds[c], v);
    bounds[c + 3] = std::max(bounds[c + 3], std::isfinite(velocity[c]) ? -v : v);
  }
}

/// The supports' moment on a turning body is along axes that are not free; held ones do not turn, so only drives do
/// work.
void book_forced_turn(const rigid::Gyroscopic& forced, BodyStep& now, model::BodyAccount& account) {
  const Vec3 impulse = forced.first_half + forced.second_half;
  now.late_turn = forced.second_half;
  now.late_work = now.given_spin.dot(impulse);
  account.reaction_angular_impulse += impulse;
  account.reaction_work += now.late_work;
}

/// impulse . (velocity before + velocity after)/2.
double work_of(const BodyStep& now, const Vec3& impulse, const Vec3& angular_impulse) {
  return 0.5 * (impulse.dot(now.before.velocity + now.after.velocity) +
                angular_impulse.dot(now.before.spin + now.after.spin));
}

/// Nodes of shells turn with the body that carries them: Cayley's vector of its rotation over the step (`now.turn` is
/// that at its start).
void turn_shells(const RigidBody& body, const rigid::BodyState& moving, double dt, const BodyStep& now,
                 model::State& state) {
  const Eigen::Quaterniond step(moving.orientation * Eigen::Quaterniond(now.turn).conjugate());
  const Vec3 rate = dt > 0 ? Vec3(2 / (step.w() * dt) * step.vec()) : now.after.spin;
  for_nodes(body, [&](std::size_t, std::size_t i) {
    model::RotationLine& line = state.rotations[i];
    Eigen::Map<Vec3>(line.rate) = rate;
    Eigen::Map<Eigen::Quaterniond>(line.turn) = moving.orientation;
  });
}

}  // namespace

void clear_body_loads(const model::Model& model, model::Scratch& scratch) {
  for (const RigidBody& body : model.bodies)
    for_nodes(body, [&](std::size_t, std::size_t i) { scratch.load[i] = Quad{}; });
}

void sum_body_forces(const model::Model& model, const model::State& state, model::Scratch& scratch, Links& links) {
  const Vec3 gravity = gravity_at(model, state.time);
  const std::size_t width = model.loaded() ? 2 * wrench_width : wrench_width;
  links.body_sums.clear();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const RigidBody& body = model.bodies[b];
    scratch.bodies[b].elements = {};
    scratch.bodies[b].loads = {body.body.mass.mass * gravity, Vec3::Zero()};
    if (!body.is_forced) continue;
    links.body_sums.resize(links.body_sums.size() + width);
    comm::ExactAccumulator* sums = &links.body_sums[links.body_sums.size() - width];
    const Vec3 centre = body.body.mass.centre + state.bodies[b].displacement;
    for (const LocalIndex k : body.forced) {
      const auto i = static_cast<std::size_t>(nth(body.nodes, k));
      const Vec3 arm = Eigen::Map<const Vec3>(state.nodes[i].x) - centre;
      add_force(of(scratch.force[i]), arm, sums);
      if (model.loaded()) add_force(of(scratch.load[i]), arm, sums + wrench_width);
      if (scratch.moment.empty()) continue;
      add_moment(scratch.moment[i], sums);
      if (model.loaded()) add_moment(scratch.moment_load[i], sums + wrench_width);
    }
  }
  if (links.body_sums.empty()) return;
  links.body_forces.resize(links.body_sums.size());
  comm::exact_sum(links.ranks, links.body_sums, links.body_forces);
  const double* values = links.body_forces.data();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!model.bodies[b].is_forced) continue;
    BodyStep& now = scratch.bodies[b];
    now.elements = wrench_of(values);
    if (model.loaded()) {
      const model::Wrench loads = wrench_of(values + wrench_width);
      now.loads.force += loads.force;
      now.loads.moment += loads.moment;
    }
    values += width;
  }
}

void predict_bodies(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step,
                    contact::VelocitySpan& velocities) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    predict(model, state, model.bodies[b], state.bodies[b], step, scratch.bodies[b]);
  hold_joints(model, state, step, scratch);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyStep& now = scratch.bodies[b];
    for_nodes(model.bodies[b], [&](std::size_t, std::size_t i) {
      const Vec3 arm = Eigen::Map<const Vec3>(state.nodes[i].x) - now.centre;
      widen(scratch.before[i], velocities.data());  // with its current velocity
      scratch.before[i] = now.before.velocity + now.before.spin.cross(arm);
      Eigen::Map<Vec3> predicted(state.nodes[i].v);
      predicted = now.predicted.velocity + now.predicted.spin.cross(arm);
      widen(predicted, velocities.data() + 6);
      if (state.rotations.empty()) return;
      for (int c = 0; c < 3; ++c) scratch.rate_before[i][c] = now.before.spin[c];
      Eigen::Map<Vec3>(state.rotations[i].rate) = now.predicted.spin;
    });
  }
}

rigid::Mat6 mobility_of(const RigidBody& body, const BodyStep& now, double drag) {
  const double share = 1 / (1 + drag);
  rigid::Mat6 mobility = rigid::Mat6::Zero();
  mobility.topLeftCorner<3, 3>() = share / body.body.mass.mass * body.support.free_shift;
  mobility.bottomRightCorner<3, 3>() =
      share * (body.support.holds_turn ? rigid::supported_mobility(body.support.free_turn, now.inertia) : now.inverse);
  return mobility;
}

void carriers_of_bodies(const model::Model& model, const model::Scratch& scratch, double drag,
                        std::vector<contact::Carrier>& carriers, std::vector<contact::CoupledBodies>& coupled) {
  carriers.resize(model.bodies.size());
  for (std::size_t b = 0; b < carriers.size(); ++b) {
    const BodyStep& now = scratch.bodies[b];
    carriers[b] = {now.centre, mobility_of(model.bodies[b], now, drag), now.predicted.spin};
  }
  couple_carriers(model, scratch, carriers, coupled);
}

void push_body(const RigidBody& body, const rigid::Vec6& impulse, const rigid::Vec6& change, double drag,
               BodyStep& now) {
  now.after.velocity += change.head<3>();
  // impulses along constrained directions act on the supports
  if (body.support.holds_shift)
    now.reaction.force += (1 + drag) * body.body.mass.mass * change.head<3>() - impulse.head<3>();
  if (body.support.holds_turn) {
    const Vec3 let_through = now.inertia * change.tail<3>();
    now.after.angular_momentum += let_through;
    now.reaction.moment += (1 + drag) * let_through - impulse.tail<3>();
  } else {
    now.after.angular_momentum += impulse.tail<3>() / (1 + drag);
  }
  now.after.spin = now.inverse * now.after.angular_momentum;
}

void push_bodies(const model::Model& model, std::span<const contact::BodyAnswer> answers, const Interval& step,
                 model::State& state, model::Scratch& scratch) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (!model.bodies[b].is_jointed)
      push_body(model.bodies[b], answers[b].impulse, answers[b].change, step.drag, scratch.bodies[b]);
  push_jointed(model, state, answers, step, scratch);
  if (!model.between_parts.booked) return;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyStep& now = scratch.bodies[b];
    for_nodes(model.bodies[b], [&](std::size_t, std::size_t i) {
      const Vec3 arm = Eigen::Map<const Vec3>(state.nodes[i].x) - now.centre;
      Eigen::Map<Vec3>(state.nodes[i].v) = now.after.velocity + now.after.spin.cross(arm);
      if (!state.rotations.empty()) Eigen::Map<Vec3>(state.rotations[i].rate) = now.after.spin;
    });
  }
}

void book_bodies(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step) {
  book_joints(model, state, scratch);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyStep& now = scratch.bodies[b];
    const double mass = model.bodies[b].body.mass.mass;
    model::BodyAccount& account = state.body_accounts[b];
    const Vec3 push = step.dt_mean * now.loads.force, turn = step.dt_mean * now.loads.moment;
    const Vec3 drag = -step.drag * mass * (now.before.velocity + now.after.velocity);
    const Vec3 drag_moment = -step.drag * (now.before.angular_momentum + now.after.angular_momentum);
    account.element_work += work_of(now, step.dt_mean * now.elements.force, step.dt_mean * now.elements.moment);
    account.load_work += work_of(now, push, turn);
    account.damping_work += work_of(now, drag, drag_moment);
    account.reaction_work += work_of(now, now.reaction.force, now.reaction.moment) + now.pivot_work;
    account.load_impulse += push + drag;
    const Vec3 force = now.reaction.force + now.pivot.force, moment = now.reaction.moment + now.pivot.moment;
    account.reaction_impulse += force;
    account.reaction_angular_impulse += moment;
    account.impulse += mass * (now.after.velocity - now.before.velocity) - force;
    account.angular_impulse += now.after.angular_momentum - now.before.angular_momentum - moment;
  }
}

rigid::Gyroscopic advance_body(const RigidBody& body, const BodyStep& now, double dt, rigid::BodyState& moving) {
  moving.velocity = now.after.velocity;
  moving.angular_momentum = now.after.angular_momentum;
  if (body.support.holds_turn)
    return rigid::move_supported(body.body, body.support.free_turn, now.given_spin, dt, moving);
  rigid::move(body.body, dt, moving);
  return {};
}

void move_bodies(const model::Model& model, model::State& state, model::Scratch& scratch, double dt) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const RigidBody& body = model.bodies[b];
    BodyStep& now = scratch.bodies[b];
    rigid::BodyState& moving = state.bodies[b];
    const rigid::Gyroscopic forced = advance_body(body, now, dt, moving);
    if (body.support.holds_turn) book_forced_turn(forced, now, state.body_accounts[b]);
    if (!state.rotations.empty()) turn_shells(body, moving, dt, now, state);
    const Mat3 turn = moving.orientation.toRotationMatrix() - Mat3::Identity();
    for_nodes(body, [&](std::size_t k, std::size_t i) {
      const Vec3 u = moving.displacement + turn * body.arm[k];
      Eigen::Map<Vec3>(state.nodes[i].v) = (u - of(state.displacement[i])) / dt;
      for (int c = 0; c < 3; ++c) {
        state.displacement[i][c] = u[c];
        state.nodes[i].x[c] = model.reference[i][c] + u[c];
      }
    });
  }
}

}  // namespace brunt::time
