// SPDX-License-Identifier: Apache-2.0
// Contact as part of the system: its matrix against differences, momentum, what supports take out.
#include "implicit/mortar/mortar.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <random>

#include "implicit/balance.hpp"
#include "implicit/commit.hpp"
#include "implicit/step.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/implicit_system.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

/// Two blocks of meshes that do not match, which touch or have a gap.
Simulation pressed(const std::string& contact, double gap = 0) {
  mesh::Mesh mesh = mesh::box("low", {1, 1, 0.5}, {2, 2, 1}), above = mesh::box("top", {0.9, 1.1, 0.5}, {3, 3, 1});
  for (Vec3& x : above.coordinates) x += Vec3(0.02, -0.03, 0.5 + gap);
  mesh::append(mesh, std::move(above));
  return {std::move(mesh),
          "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}}\n"
          "parts: {low: {material: m, element: hex8_full}, top: {material: m, element: "
          "hex8_full}}\nsets: {foot: {part: low, box: [[0, 0, 0], [1, 1, 0]]}}\n"
          "fixed: [{set: foot, dofs: [x, y, z]}]\ncontact: [{between: [low, top], method: mortar, " +
              contact + "}]\n"};
}

model::ImplicitSolver settings_of(model::Scheme scheme) {
  model::ImplicitSolver settings;
  settings.scheme = scheme;
  settings.step = settings.max_step = 0.01;
  settings.min_step = 1e-5;
  return settings;
}

}  // namespace

TEST_CASE("The surface of a slice between two planes of symmetry ends at its edges, not at the planes") {
  mesh::Mesh mesh = mesh::box("low", {1, 0.5, 0.5}, {3, 1, 1}), above = mesh::box("top", {0.5, 0.5, 0.5}, {2, 1, 1});
  for (Vec3& x : above.coordinates) x += Vec3(0.2, 0, 0.5);
  mesh::append(mesh, std::move(above));
  Simulation body{std::move(mesh),
                  "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}}\n"
                  "parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}\n"
                  "symmetry: [{point: [0, 0, 0], normal: [0, 1, 0]}, {point: [0, 0.5, 0], normal: [0, 1, 0]}]\n"
                  "contact: [{between: [low, top], method: mortar, edges: true}]\n"};
  const Scene scene{body.model, body.state, body.scratch, body.links};
  const Solver solver = make_solver(scene, settings_of(model::Scheme::statics));
  int interfaces = 0;
  for (const Interface& face : solver.contact.interfaces) {
    if (!face.of_points) continue;
    ++interfaces;
    int rims = 0;
    for (const contact::PatchNumbers& of : face.own_masters.patch)
      rims += std::popcount(static_cast<std::uint64_t>(of.rims));
    CHECK(rims == 8);  // of each body: four edges across the slice, two facets each
  }
  CHECK(interfaces == 2);
}

TEST_CASE("the matrix with contact is the derivative of the residual: multipliers, penalty, friction, ties") {
  const model::Scheme scheme = GENERATE(model::Scheme::contact_implicit, model::Scheme::statics);
  const std::string contact =
      GENERATE(std::string("friction: 0"), std::string("multiplier: standard"), std::string("enforce: penalty"),
               std::string("friction: 0.05"), std::string("friction: 5"),
               std::string("enforce: penalty, friction: 0.3"), std::string("edges: true"),
               std::string("edges: true, friction: 0.05"), std::string("tied: true"), std::string("tied: true "));
  CAPTURE(contact, scheme);
  Simulation body = pressed(contact, contact.ends_with(' ') ? 0.06 : 0);
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings_of(scheme));
  REQUIRE(solver.contact.any());
  begin_step(scene, solver, 0.01, 0.01);
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> shake(-0.01, 0.01);
  const std::size_t nodes = solver.unknowns.node.size();
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t c = 0; c < 3; ++c) solver.u[3 * k + c] += shake(engine);
  const GlobalIndex in_low = 18;
  for (GlobalIndex n = in_low; n < body.nodes(); ++n) {  // the upper block is pressed in, and drawn along
    const auto at = std::ranges::lower_bound(solver.unknowns.node, body.node(n)) - solver.unknowns.node.begin();
    solver.u[3 * static_cast<std::size_t>(at)] += 0.01;
    solver.u[3 * static_cast<std::size_t>(at) + 2] -= 0.02;
  }
  for (std::size_t k = 3 * nodes; k < solver.u.size(); ++k) solver.u[k] = 20 + 100 * shake(engine);
  // rows of edges fade over a tenth of a facet: their third derivatives are large (the error falls with the square)
  const double step = contact.starts_with("edges") ? 2e-7 : 1e-6;
  const auto step_of = [&](std::size_t unknown) { return unknown < 3 * nodes ? step : 1e-3; };  // a pressure is large
  CHECK(test::tangent_error(scene, solver, step_of) < 1e-7);

  (void)test::residual_at(scene, solver, solver.u);
  CHECK(count(solver.contact).active > 5);
  Vec3 sum = Vec3::Zero();
  double size = 0;
  for (const Vec3& force : solver.contact.nodes.force) {
    sum += force;
    size += force.norm();
  }
  CHECK(size > 1);
  CHECK(sum.norm() < 1e-14 * size);
}
