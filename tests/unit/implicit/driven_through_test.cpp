// SPDX-License-Identifier: Apache-2.0
// Bodies that supports drive through each other or through a wall are told of once, with their depth.
#include <catch2/catch.hpp>

#include "implicit/commit.hpp"
#include "implicit/driven_apart.hpp"
#include "implicit/step.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

Simulation stack(const std::string& more) {
  mesh::Mesh mesh = mesh::box("low", {1, 1, 1}, {2, 2, 1}), above = mesh::box("top", {1, 1, 1}, {3, 3, 1});
  for (Vec3& x : above.coordinates) x += Vec3(0, 0, 1);
  mesh::append(mesh, std::move(above));
  return {std::move(mesh),
          "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}}\n"
          "parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}\n"
          "curves: {down: [[0, 0], [1, -0.1]], rate: [[0, 0.1]]}\n" +
              more};
}

std::vector<DrivenThrough> found(Simulation& body, double& depth) {
  model::ImplicitSolver settings;
  settings.scheme = model::Scheme::statics;
  settings.step = settings.max_step = 0.1;
  settings.min_step = 1e-3;
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings);
  std::vector<DrivenThrough> told;
  for (int step = 0; step < 3; ++step) {
    advance(scene, solver, [](GlobalIndex) { return std::string("a node"); });
    for (const DrivenThrough& pair : watch_driven(scene, solver)) told.push_back(pair);
  }
  depth = driven_penetration(solver);
  return told;
}

}  // namespace

TEST_CASE("a body that is driven into a fixed one is told of once") {
  Simulation body = stack(
      "sets: {under: {part: low, box: [[0, 0, 1], [1, 1, 1]]}, over: {part: top, box: [[0, 0, 1], [1, 1, 1]]}}\n"
      "fixed: [{set: under, dofs: [x, y, z]}, {set: over, dofs: [x, y]}]\n"
      "prescribed: [{set: over, dof: z, displacement: down}]\ncontact: [{between: [low, top], method: mortar}]\n");
  double depth = 0;
  const auto told = found(body, depth);
  REQUIRE(told.size() == 1);
  CHECK(told[0].block + told[0].other == 1);
  CHECK(told[0].since == Approx(0.1));
  CHECK(told[0].depth == Approx(0.01));
  CHECK(depth == Approx(0.03));
}

TEST_CASE("a wall that is driven through held nodes is told of once") {
  const std::string wall = "rigid_walls: [{name: ram, point: [0, 0, 2], normal: [0, 0, -1], motion: rate}]\n";
  double depth = 0;
  Simulation held = stack("fixed: [{part: low, dofs: [x, y, z]}, {part: top, dofs: [x, y, z]}]\n" + wall);
  const auto told = found(held, depth);
  REQUIRE(told.size() == 1);
  CHECK(told[0].block == 1);
  CHECK(told[0].other == -1);
  CHECK(depth == Approx(0.03));
}
