// SPDX-License-Identifier: Apache-2.0
// Ties on walls: slave nodes of a seam that stands on a wall are carried by the tie.
#include <algorithm>
#include <catch2/catch.hpp>

#include "brunt/implicit/balance.hpp"
#include "brunt/implicit/commit.hpp"
#include "brunt/implicit/mortar.hpp"
#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
#include "support/implicit_system.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

/// Two blocks side by side, the right one finer; `more` of the scene.
Simulation side_by_side(const std::string& more) {
  mesh::Mesh mesh = mesh::box("left", {1, 1, 1}, {2, 2, 2}), right = mesh::box("right", {1, 1, 1}, {3, 3, 3});
  for (Vec3& x : right.coordinates) x += Vec3(1, 0, 0);
  mesh::append(mesh, std::move(right));
  return {std::move(mesh),
          "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}}\n"
          "parts: {left: {material: m, element: hex8_full}, right: {material: m, element: hex8_full}}\n"
          "contact: [{between: [left, right], method: mortar, tied: true}]\n" +
              more};
}

model::ImplicitSolver settings() {
  model::ImplicitSolver settings;
  settings.scheme = model::Scheme::contact_implicit;
  settings.step = settings.max_step = 0.01;
  settings.min_step = 1e-5;
  return settings;
}

bool is_seam(const Vec3& X) {
  return X[0] == 1 && X[2] == 0;
}

}  // namespace

TEST_CASE("a tie carries the slave's nodes of a seam on a floor, and its rows are whole") {
  Simulation body = side_by_side(
      "gravity: {vector: [0, 0, -10]}\n"
      "rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]\n");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings());
  begin_step(scene, solver, 0.01, 0.01);
  (void)test::residual_at(scene, solver, solver.u);
  const MortarContact& contact = solver.contact;
  const Interface& face = contact.interfaces[0];
  int carried = 0;
  for (const WallNode& node : solver.walls.nodes)
    carried += node.tied.isApprox(Mat3(Vec3(0, 0, 1).asDiagonal())) ? 1 : 0;
  CHECK(carried == 4);
  for (std::size_t row = 0; row < face.count(); ++row)
    if (face.tie.covered[row] > 0) CHECK(face.tied[row].isIdentity(1e-12));
  for (std::size_t k = 0; k < contact.nodes.lasting; ++k) {
    const bool slave = std::ranges::binary_search(face.surfaces.rows, static_cast<LocalIndex>(k));
    const bool on_floor = contact.nodes.reference[k][2] == 0;
    const bool lifted = slave && is_seam(contact.nodes.reference[k]);
    CHECK(contact.nodes.movable[k](2, 2) == Approx(on_floor && !lifted ? 0 : 1).margin(1e-12));
  }
  CHECK(factorise_tangent(scene, solver).ok());
  CHECK(test::tangent_error(scene, solver, [](std::size_t) { return 1e-6; }) < 1e-6);
}
