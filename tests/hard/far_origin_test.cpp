// SPDX-License-Identifier: Apache-2.0
// E16: the same impact, and the same two blocks pressed together, at the origin and 1e6 m away, with elements of 1 mm.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
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

TEST_CASE("an impact 1e6 m from the origin ends as at the origin", "[law]") {
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
  CHECK(near.contact->ledger.statistics.solved_steps > 10);
}

namespace {

constexpr double unit = 1.0 / 4096;  ///< [m]; its multiples are exact 1e6 m away, so that both scenes are the same

/// The contact patch test (A7): 3 columns below 4, three rows each, the upper block pressed down evenly. Elements of 1
/// mm.
Simulation patch(const Vec3& at) {
  mesh::Mesh mesh = mesh::box("lower", {12 * unit, 6 * unit, 2 * unit}, {3, 3, 1});
  mesh::Mesh upper = mesh::box("upper", {12 * unit, 6 * unit, 2 * unit}, {4, 3, 1});
  mesh::place(upper, 1, {0, 0, 1}, 0, {0, 6 * unit, 0});
  mesh::append(mesh, std::move(upper));
  mesh::place(mesh, 1, {0, 0, 1}, 0, at);
  const auto plane = [&](const Vec3& point, const char* normal) {
    return fmt::format("{{point: [{}, {}, {}], normal: {}}}", at.x() + point.x(), at.y() + point.y(),
                       at.z() + point.z(), normal);
  };
  // times as those of blocks 1 m wide, E = rho = 1: a ramp of 29 transits, then as long at full load, damped
  return {std::move(mesh),
          "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0.3}}\n"
          "parts: {lower: {material: m, element: hex8_full}, upper: {material: m, element: hex8_full}}\n"
          "fixed: [{set: lower_ymin, dofs: [y]}]\n"
          "symmetry: [" +
              plane({0, 0, 0}, "[1, 0, 0]") + ", " + plane({0, 0, 0}, "[0, 0, 1]") + ", " +
              plane({0, 0, 2 * unit}, "[0, 0, -1]") +
              "]\ncurves: {ramp: [[0, 0], [0.073, 1]]}\n"
              "pressure: [{set: upper_ymax, value: 1.0e-4, curve: ramp}]\ndamping: {alpha: 680}\n"
              "contact: [{between: [lower, upper], slave: upper, tolerance: 1.0e-6}]\n"};
}

}  // namespace

// Blocks whose coordinates are not exact there (1e-10 m, 1e-7 of an element) differ by what these gaps are to the
// displacements: 1e-3 at this load.
TEST_CASE("blocks pressed together 1e6 m from the origin are stressed as at the origin", "[law]") {
  Simulation near = patch({0, 0, 0}), far = patch({1e6, -1e6, 1e6});
  while (near.state.time < 0.15) near.step();
  while (far.state.time < 0.15) far.step();
  REQUIRE(far.state.step == near.state.step);
  double largest = 0;
  for (GlobalIndex node = 0; node < near.nodes(); ++node)
    largest = std::max(largest, near.displacement(near.node(node)).norm());
  CHECK(largest > 0.9e-4 * 12 * unit);  // two blocks of half the width, a strain of 1e-4 each
  for (GlobalIndex node = 0; node < near.nodes(); ++node) {
    CHECK((far.displacement(far.node(node)) - near.displacement(near.node(node))).norm() <= 1e-6 * largest);
    CHECK((far.force(far.node(node)) - near.force(near.node(node))).norm() <= 1e-6 * 1e-4 * 12 * unit * 2 * unit);
  }
  CHECK(far.ledger().internal == Approx(near.ledger().internal).epsilon(1e-6));
  CHECK(contact::collect(*near.contact).active == 2 * 5);
}
