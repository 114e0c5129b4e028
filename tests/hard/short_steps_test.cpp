// SPDX-License-Identifier: Apache-2.0
// What contact does may not depend on how short the steps are.
#include <catch2/catch.hpp>
#include <string>

#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
#include "given_back.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::GivenBack, test::Simulation;

// One pass: nodes of the lower cube are first seen deep, behind the rim of the upper one. A share of their depth in
// each step shot them out, the faster the shorter the step: 3e-5 of the energy at a cfl of 0.9, 0.066 at 0.1.
TEST_CASE("a cube falls on the rim of another one in short steps: contact gives none of the energy") {
  const double cfl = GENERATE(0.9, 0.1, 0.03);
  mesh::Mesh mesh = mesh::box("lower", {0.1, 0.1, 0.1}, {3, 3, 3}),
             upper = mesh::box("upper", {0.1, 0.1, 0.1}, {5, 5, 5});
  mesh::place(upper, 1, {0, 0, 1}, 7, {0.06, 0.055, 0.1005});
  mesh::append(mesh, std::move(upper));
  Simulation scene(std::move(mesh),
                   "materials: {steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}\n"
                   "parts: {lower: {material: steel}, upper: {material: steel}}\n"
                   "initial: [{part: upper, velocity: [0, 0, -50]}]\n"
                   "contact: [{between: all, passes: one}]\n");
  scene.control.cfl = cfl;
  const GivenBack contact = run_until(scene, 2e-4);
  constexpr double energy = 0.5 * 7.8 * 50 * 50;
  CAPTURE(cfl, contact.given / energy);
  CHECK(contact.given <= 1e-3 * energy);
  CHECK(contact.most > 1e-3 * energy);  // they met
}
