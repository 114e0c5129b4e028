// SPDX-License-Identifier: Apache-2.0
// Two blocks side by side whose meshes do not match, joined or in contact across the plane x = 1, in implicit steps.
#pragma once
#include <string>
#include <utility>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

namespace brunt::test {

/// The right one is finer; `joint` belongs to the entry of contact, `more` to the scene.
inline Simulation side_by_side(const std::string& joint, const std::string& more) {
  mesh::Mesh mesh = mesh::box("left", {1, 1, 1}, {2, 2, 2}), right = mesh::box("right", {1, 1, 1}, {3, 3, 3});
  for (Vec3& x : right.coordinates) x += Vec3(1, 0, 0);
  mesh::append(mesh, std::move(right));
  return {std::move(mesh),
          "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}}\n"
          "parts: {left: {material: m, element: hex8_full}, right: {material: m, element: hex8_full}}\n"
          "contact: [{between: [left, right], method: mortar" +
              joint + "}]\n" + more};
}

inline model::ImplicitSolver short_steps() {
  model::ImplicitSolver settings;
  settings.scheme = model::Scheme::contact_implicit;
  settings.step = settings.max_step = 0.01;
  settings.min_step = 1e-5;
  return settings;
}

}  // namespace brunt::test
