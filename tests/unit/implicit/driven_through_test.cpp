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
using Catch::Contains;
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

std::vector<std::string> warnings(Simulation& body, double& depth) {
  model::ImplicitSolver settings;
  settings.scheme = model::Scheme::statics;
  settings.step = settings.max_step = 0.1;
  settings.min_step = 1e-3;
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings);
  std::vector<std::string> told;
  for (int step = 0; step < 3; ++step) {
    advance(scene, solver, [](GlobalIndex) { return std::string("a node"); });
    for (std::string& line : watch_driven(scene, solver, "mm")) told.push_back(std::move(line));
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
  const auto told = warnings(body, depth);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0],
             Contains("through each other: since t = 0.1 ") && Contains("part 'low'") && Contains("part 'top'"));
  CHECK_THAT(told[0], Contains("the depth is now 0.01 mm"));
  CHECK(depth == Approx(0.03));
}

TEST_CASE("a wall that is driven through held nodes is told of once") {
  const std::string wall = "rigid_walls: [{name: ram, point: [0, 0, 2], normal: [0, 0, -1], motion: rate}]\n";
  double depth = 0;
  Simulation held = stack("fixed: [{part: low, dofs: [x, y, z]}, {part: top, dofs: [x, y, z]}]\n" + wall);
  const auto told = warnings(held, depth);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Contains("part 'top' and rigid wall 'ram'"));
  CHECK(depth == Approx(0.03));
}
