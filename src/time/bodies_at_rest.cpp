// SPDX-License-Identifier: Apache-2.0
#include "time/bodies_at_rest.hpp"

#include <Eigen/Geometry>

#include "time/bodies.hpp"

namespace brunt::time {

std::vector<char> nodes_of_bodies(const model::Model& model) {
  std::vector<char> carried(model.bodies.empty() ? 0 : static_cast<std::size_t>(model.nodes()), 0);
  for (const model::RigidBody& body : model.bodies)
    for (const LocalIndex node : body.nodes) nth(carried, node) = 1;
  return carried;
}

double kinetic_energy_of_bodies(const model::Model& model, const model::State& state) {
  double energy = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    energy += rigid::kinetic_energy(model.bodies[b].body, state.bodies[b]);
  return energy;
}

void scale_body_loads(double share, model::Scratch& scratch) {
  for (model::BodyStep& body : scratch.bodies) {
    body.loads.force *= share;
    body.loads.moment *= share;
  }
}

BodyBalance balance_of_bodies(const model::Model& model, const model::Scratch& scratch, double dt_mean) {
  BodyBalance balance;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const rigid::MassProperties& mass = model.bodies[b].body.mass;
    const model::BodyStep& now = scratch.bodies[b];
    const double square_of_radius = mass.inertia.trace() / (2 * mass.mass);
    const auto size = [&](const Vec3& force, const Vec3& moment) {
      return force.squaredNorm() + (square_of_radius > 0 ? moment.squaredNorm() / square_of_radius : 0.0);
    };
    balance.left += size(mass.mass / dt_mean * (now.after.velocity - now.before.velocity),
                         (now.after.angular_momentum - now.before.angular_momentum) / dt_mean);
    balance.given += size(now.loads.force, now.loads.moment);
  }
  return balance;
}

void keep_held_wrenches(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const model::BodyStep& now = scratch.bodies[b];
    const double mass = model.bodies[b].body.mass.mass;
    state.held_wrench[b] = {
        mass / dt_mean * (now.after.velocity - now.before.velocity) - now.elements.force - now.loads.force,
        (now.after.angular_momentum - now.before.angular_momentum) / dt_mean - now.elements.moment - now.loads.moment};
  }
}

void stop_bodies(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const model::RigidBody& body = model.bodies[b];
    const model::BodyStep& now = scratch.bodies[b];
    const model::Wrench& held = state.held_wrench[b];
    rigid::BodyState& moving = state.bodies[b];
    const Vec3 force = now.elements.force + now.loads.force + held.force;
    const Vec3 moment = now.elements.moment + now.loads.moment + held.moment;
    moving.velocity = -0.5 * dt_mean / body.body.mass.mass * (body.support.free_shift * force);
    const Mat3 inertia = rigid::inertia_now(body.body, moving);
    const Vec3 momentum = -0.5 * dt_mean * moment;
    moving.angular_momentum =
        body.support.holds_turn
            ? Vec3(inertia * rigid::supported_spin(body.support.free_turn, inertia, momentum, Vec3::Zero()))
            : momentum;
    const Vec3 spin = rigid::angular_velocity(body.body, moving);
    for_nodes(body, [&](std::size_t k, std::size_t i) {
      Eigen::Map<Vec3>(state.nodes[i].v) = moving.velocity + spin.cross(moving.orientation * body.arm[k]);
    });
  }
}

void add_work_on_bodies(const model::Model& model, const model::Scratch& scratch, double half_step, bool after,
                        model::State& state) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const model::BodyStep& now = scratch.bodies[b];
    const rigid::BodyState& moving = state.bodies[b];
    const Vec3 spin = after ? now.after.spin : rigid::angular_velocity(model.bodies[b].body, moving);
    state.body_accounts[b].element_work +=
        half_step * (moving.velocity.dot(now.elements.force) + spin.dot(now.elements.moment));
    for_nodes(model.bodies[b], [&](std::size_t, std::size_t i) { state.displacement[i][3] = 0; });
  }
}

void begin_accounts_of_bodies(model::State& state) {
  for (model::BodyAccount& account : state.body_accounts) {
    const double work = account.element_work;
    account = {};
    account.element_work = work;
    account.load_work = -work;
  }
}

}  // namespace brunt::time
