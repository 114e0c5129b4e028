// SPDX-License-Identifier: Apache-2.0
#include "force/loads.hpp"

#include <Eigen/Geometry>

#include "core/cells.hpp"
#include "model/curve.hpp"

namespace brunt::force {
namespace {

Vec3 position(const model::State& state, LocalIndex node) {
  return Eigen::Map<const Vec3>(nth(state.nodes, node).x);
}

}  // namespace

double damping_rate(const model::Model& model, double time) {
  return time >= model.loads.damping.from && time < model.loads.damping.to ? model.loads.damping.alpha : 0.0;
}

void body_loads(const model::Model& model, const model::State& state, model::Scratch& scratch) {
  const Vec3 gravity =
      model.loads.gravity * (model.has_gravity() ? model::value_at(model.loads.gravity_curve, state.time) : 0.0);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const double m = state.nodes[i].mass;
    scratch.load[i] = Quad{m * gravity[0], m * gravity[1], m * gravity[2]};
  }
}

void pressure_forces(const model::Model& model, const model::State& state, std::span<Quad> slots) {
  std::size_t slot = 0;
  for (std::size_t entry = 0; entry < model.loads.pressure.size(); ++entry) {
    const model::PressureLoad& load = model.loads.pressure[entry];
    const double whole = load.value * model::value_at(load.curve, state.time);
    const char* lives = state.living.pressed.empty() ? nullptr : state.living.pressed[entry].data();
    for (const mesh::ExteriorFace& face : load.faces) {
      const double p = lives == nullptr || *lives++ != 0 ? whole : 0.0;  // a load ends with the element of its face
      const int corners = static_cast<int>(cells::corner_count(face.nodes));
      const Vec3 a = position(state, face.nodes[0]), b = position(state, face.nodes[1]),
                 c = position(state, face.nodes[2]);
      // area vector of a bilinear face: half the cross product of its diagonals
      const Vec3 area = corners == 3 ? Vec3(0.5 * (b - a).cross(c - a))
                                     : Vec3(0.5 * (c - a).cross(position(state, face.nodes[3]) - b));
      const Vec3 share = -p / corners * area;
      for (int k = 0; k < corners; ++k) slots[slot++] = Quad{share[0], share[1], share[2]};
    }
  }
}

std::vector<PressureCorner> pressure_corners(const model::Model& model) {
  std::vector<PressureCorner> corners;
  GlobalIndex load_number = 0;
  for (const model::PressureLoad& load : model.loads.pressure) {
    for (const mesh::ExteriorFace& face : load.faces)
      for (std::size_t k = 0; k < cells::corner_count(face.nodes); ++k)
        corners.push_back(
            {(load_number << 56) + cells::key_of_face_corner(face.key, static_cast<int>(k)), face.nodes[k]});
    ++load_number;
  }
  return corners;
}

}  // namespace brunt::force
