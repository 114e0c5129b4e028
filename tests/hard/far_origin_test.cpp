// SPDX-License-Identifier: Apache-2.0
// The same impact at the origin and 1e6 m away from it, with elements of 1 mm.
#include <catch2/catch.hpp>

#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

/// Two equal bars of nu = 0; the first meets the second at 10 m/s.
Simulation impact(const Vec3& at) {
  mesh::Mesh mesh = mesh::box("left", {0.02, 0.001, 0.001}, {20, 1, 1});
  mesh::Mesh right = mesh::box("right", {0.02, 0.001, 0.001}, {20, 1, 1});
  mesh::place(right, 1, {0, 0, 1}, 0, {0.02, 0, 0});
  mesh::append(mesh, std::move(right));
  mesh::place(mesh, 1, {0, 0, 1}, 0, at);
  return {std::move(mesh),
          "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0}}\n"
          "parts: {left: {material: m}, right: {material: m}}\n"
          "initial: [{part: left, velocity: [10, 0, 0]}]\n"
          "contact: [{between: all}]\n"};
}

}  // namespace

TEST_CASE("an impact 1e6 m from the origin ends as at the origin") {
  Simulation near = impact({0, 0, 0}), far = impact({1e6, -1e6, 1e6});
  for (const double until : {4e-6, 1.2e-5}) {  // in the middle of contact, and after it
    while (near.state.time < until) near.step();
    while (far.state.time < until) far.step();
    CHECK(far.state.step == near.state.step);
    CHECK(far.state.time == Approx(near.state.time).epsilon(1e-6));
    const time::Ledger a = near.ledger(), b = far.ledger();
    CHECK(b.kinetic == Approx(a.kinetic).epsilon(1e-6));
    CHECK(b.internal == Approx(a.internal).epsilon(1e-6).margin(1e-6 * a.kinetic));
    for (GlobalIndex node = 0; node < near.nodes(); node += 4) {
      CHECK((far.displacement(far.node(node)) - near.displacement(near.node(node))).norm() < 1e-6 * 10 * until);
      CHECK((far.velocity(far.node(node)) - near.velocity(near.node(node))).norm() < 1e-6 * 10);
    }
  }
  CHECK(near.contact->statistics().solved_steps > 10);
}
