// SPDX-License-Identifier: Apache-2.0
#include "implicit/static_forces.hpp"

#include <array>

#include "comm/exact_sum.hpp"
#include "implicit/data/nodal.hpp"
#include "model/curve.hpp"

namespace brunt::implicit {
namespace {

/// Of elements, loads, contact and walls.
Vec3 acting_on(const Memory& memory, std::size_t node) {
  return of(memory.internal_force, node) + of(memory.load, node) + of(memory.contact_force, node) +
         of(memory.wall_force, node);
}

/// A static run begins without loads.
Vec3 weight_of(const Scene& scene, const model::RigidBody& body) {
  if (!scene.model.has_gravity() || scene.state.step == 0) return Vec3::Zero();
  return body.body.mass.mass * model::value_at(scene.model.loads.gravity_curve, scene.state.time) *
         scene.model.loads.gravity;
}

}  // namespace

bool is_static(const Solver& solver) {
  return solver.settings.scheme == model::Scheme::statics;
}

Vec3 support_force(const model::Model& model, const Solver& solver, std::size_t node) {
  const LocalIndex held = solver.held[node];
  if (held == no_index) return Vec3::Zero();
  const Vec3 acting = acting_on(solver.memory, node);
  return nth(model.supports.nodes, held).free * acting - acting;
}

model::Wrench force_on_body(const Scene& scene, const Solver& solver, std::size_t body) {
  const Mat3 turn = scene.state.bodies[body].orientation.toRotationMatrix();
  std::array<comm::ExactAccumulator, 6> sums;
  for (std::size_t own = 0; own < solver.bodies.place.size(); ++own) {
    const RigidBodies::Place& place = solver.bodies.place[own];
    if (place.body != static_cast<LocalIndex>(body)) continue;
    const Vec3 force = acting_on(solver.memory, static_cast<std::size_t>(solver.unknowns.node[own]));
    const Vec3 moment = (turn * place.arm).cross(force);
    for (int c = 0; c < 3; ++c) {
      nth(sums, c).add(force[c]);
      sums[static_cast<std::size_t>(c) + 3].add(moment[c]);
    }
  }
  std::array<double, 6> value{};
  comm::exact_sum(scene.links.ranks, sums, value);
  return {Vec3(value[0], value[1], value[2]) + weight_of(scene, scene.model.bodies[body]),
          Vec3(value[3], value[4], value[5])};
}

model::Wrench support_of_body(const model::RigidBody& body, const model::Wrench& acting) {
  return {body.support.free_shift * acting.force - acting.force,
          body.support.free_turn * acting.moment - acting.moment};
}

}  // namespace brunt::implicit
