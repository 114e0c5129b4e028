// SPDX-License-Identifier: Apache-2.0
#include "force/dead_loads.hpp"

#include <Eigen/Geometry>

#include "model/curve.hpp"

namespace brunt::force {

double reference_area(const model::Model& model, const mesh::ExteriorFace& face) {
  const auto X = [&](std::size_t k) -> const Vec3& { return nth(model.mesh.coordinates, face.nodes[k]); };
  const bool triangle = face.nodes[3] == no_index;
  const Vec3 first = triangle ? X(1) - X(0) : X(2) - X(0), second = triangle ? X(2) - X(0) : X(3) - X(1);
  return 0.5 * first.cross(second).norm();
}

void add_dead_loads(const model::Model& model, double time, model::Scratch& scratch) {
  for (const model::DeadLoad& load : model.loads.dead) {
    const Vec3 value = model::value_at(load.curve, time) * load.value;
    const Quad whole{value[0], value[1], value[2]};
    for (std::size_t k = 0; k < load.nodes.size(); ++k) nth(scratch.load, load.nodes[k]) += load.weight[k] * whole;
    if (load.moment.isZero(0)) continue;
    const Vec3 moment = model::value_at(load.curve, time) * load.moment;
    for (const LocalIndex node : load.nodes) nth(scratch.moment_load, node) += Quad{moment[0], moment[1], moment[2]};
  }
}

}  // namespace brunt::force
