// SPDX-License-Identifier: Apache-2.0
// Rows that nothing can satisfy have no multiplier.
#include <algorithm>
#include <catch2/catch.hpp>

#include "brunt/implicit/solver.hpp"
#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
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
          "contact: [{between: [left, right], method: mortar}]\n" +
              more};
}

model::ImplicitSolver settings() {
  model::ImplicitSolver settings;
  settings.scheme = model::Scheme::contact_implicit;
  settings.step = settings.max_step = 0.01;
  settings.min_step = 1e-5;
  return settings;
}

}  // namespace

TEST_CASE("rows of contact that no node can follow have no multiplier") {
  Simulation body = side_by_side("fixed: [{part: left, dofs: [x]}, {part: right, dofs: [y]}]\n");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings());
  MortarContact& contact = solver.contact;
  Interface& face = contact.interfaces[0];
  const auto pressed = [&] { return std::ranges::count(face.active, std::uint8_t{1}); };
  for (std::size_t row = 0; row < face.count(); ++row) face.active[row] = face.rows.covered[row] > 0 ? 1 : 0;
  const auto all = pressed();
  REQUIRE(all == 16);
  leave_out_redundant(body.links.ranks, contact.nodes.free, contact);
  CHECK(pressed() == all);
  const std::vector<Mat3> movable(contact.nodes.lasting, Vec3(0, 1, 1).asDiagonal());
  leave_out_redundant(body.links.ranks, movable, contact);
  CHECK(pressed() == 0);
}
