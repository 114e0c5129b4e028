// SPDX-License-Identifier: Apache-2.0
// Supports that drive the sides of a tie apart, from their curves alone and from a state.
#include "implicit/driven_apart.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

/// Two blocks, tied at z = 1; `drives`: prescribed entries. low: material of the lower one.
Simulation tied(const std::string& low, const std::string& drives) {
  mesh::Mesh mesh = mesh::box("low", {1, 1, 1}, {2, 2, 1}), above = mesh::box("top", {1, 1, 1}, {3, 3, 1});
  for (Vec3& x : above.coordinates) x += Vec3(0, 0, 1);
  mesh::append(mesh, std::move(above));
  return {
      std::move(mesh),
      "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}, hard: {model: rigid, density: "
      "2}}\n"
      "parts: {low: {material: " +
          low +
          ", element: hex8_full}, top: {material: m, element: hex8_full}}\n"
          "sets: {under: {part: low, box: [[0, 0, 1], [1, 1, 1]]}, over: {part: top, box: [[0, 0, 1], [1, 1, 1]]}}\n"
          "curves: {late: [[0, 0], [0.4, 0], [1, 0.03]], early: [[0, 0], [1, 0.03]], rate: [[0, 0.03]]}\n" +
          drives + "contact: [{between: [low, top], method: mortar, tied: true}]\n"};
}

/// The faces at z = 1 are driven.
Simulation driven(const std::string& lower, const std::string& upper) {
  return tied("m", "prescribed: [{set: under, dof: z, " + lower + "}, {set: over, dof: z, " + upper + "}]\n");
}

Solver solver_of(Simulation& body) {
  model::ImplicitSolver settings;
  settings.scheme = model::Scheme::statics;
  settings.step = settings.max_step = 0.1;
  settings.min_step = 1e-3;
  return make_solver({body.model, body.state, body.scratch, body.links}, settings);
}

}  // namespace

TEST_CASE("motions turn at the points of their curves and at the end") {
  const Simulation body = driven("displacement: late", "displacement: early");
  CHECK(turning_times(body.model, 0.8) == std::vector<double>{0.4, 0.8});
  CHECK(turning_times(body.model, 1.0) == std::vector<double>{0.4, 1.0});
}

TEST_CASE("curves that contradict each other across a tie are seen beforehand") {
  Simulation body = driven("displacement: late", "displacement: early");
  const Solver solver = solver_of(body);
  CHECK_FALSE(driven_apart_at(body.links.ranks, body.model, 0, solver.contact));
  const auto found = driven_apart_at(body.links.ranks, body.model, 0.4, solver.contact);
  REQUIRE(found);
  CHECK(std::abs(found->apart[2]) == Approx(0.012));
  CHECK(found->place[2] == Approx(1));
}

TEST_CASE("a displacement and a velocity that give the same motion agree") {
  Simulation body = driven("displacement: early", "velocity: rate");
  const Solver solver = solver_of(body);
  for (const double time : {0.1, 0.5, 1.0})
    CHECK_FALSE(driven_apart_at(body.links.ranks, body.model, time, solver.contact));
  Simulation other = driven("displacement: early", "velocity: rate, scale: 1.01");
  const Solver apart = solver_of(other);
  CHECK(driven_apart_at(other.links.ranks, other.model, 1.0, apart.contact));
}

TEST_CASE("what a state has opened is measured along the directions that both sides are held in") {
  Simulation body = driven("displacement: early", "displacement: early");
  Solver solver = solver_of(body);
  CHECK_FALSE(driven_apart(body.links.ranks, solver.contact));
  for (std::size_t k = 0; k < solver.contact.nodes.lasting; ++k)
    if (solver.contact.nodes.reference[k][2] > 1) solver.contact.nodes.x[k] += Vec3(0.1, 0, 0.1);  // not at the tie
  CHECK_FALSE(driven_apart(body.links.ranks, solver.contact));
  for (const LocalIndex node : solver.contact.interfaces[0].surfaces.rows)
    if (solver.contact.nodes.reference[static_cast<std::size_t>(node)][2] == 1)
      solver.contact.nodes.x[static_cast<std::size_t>(node)] += Vec3(0.1, 0, 0.02);
  const auto found = driven_apart(body.links.ranks, solver.contact);
  REQUIRE(found);
  CHECK(found->apart.isApprox(Vec3(0, 0, 0.02), 1e-12));
}

TEST_CASE("the shifts of a rigid body are foreseen, its turns are not") {
  const auto apart = [](const std::string& upper, const std::string& about_z) {
    Simulation body = tied(
        "hard", "prescribed: [{part: low, dof: z, displacement: early}, {set: over, dof: z, " + upper + "}" + about_z);
    const Solver solver = solver_of(body);
    return driven_apart_at(body.links.ranks, body.model, 1.0, solver.contact).has_value();
  };
  const std::string held = "]\nfixed: [{part: low, dofs: [x, y, rx, ry, rz]}]\n";
  const std::string turns = ", {part: low, dof: rz, velocity: rate}]\nfixed: [{part: low, dofs: [x, y, rx, ry]}]\n";
  CHECK_FALSE(apart("displacement: early", held));
  CHECK(apart("displacement: early, scale: 1.01", held));
  CHECK_FALSE(apart("displacement: early, scale: 1.01", turns));
}
