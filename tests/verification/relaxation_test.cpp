// SPDX-License-Identifier: Apache-2.0
// Static states found before t = 0: a hanging bar, a cantilever, blocks that rest on each other.
#include "time/relaxation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

/// Steps until the static state is found, then begins the run with the velocities at rest; steps taken.
double come_to_rest(Simulation& s, double tolerance, double most = 200000) {
  bool at_rest = false;
  while (!at_rest && s.state.relaxation.steps < most) {
    const time::RelaxationStep step =
        time::relax(s.model, s.state, s.scratch, s.links, s.contact.get(), s.control, {tolerance});
    REQUIRE_FALSE(step.step.stop);
    at_rest = step.at_rest;
  }
  CHECK(at_rest);
  time::begin_run(s.model, s.state, std::vector<Vec3>(s.state.nodes.size(), Vec3::Zero()));
  return s.state.relaxation.steps;
}

double fastest(const Simulation& s) {
  double speed = 0;
  for (LocalIndex i = 0; i < s.nodes(); ++i) speed = std::max(speed, s.velocity(i).norm());
  return speed;
}

const std::string soft = "materials: {m: {model: elastic, density: 1000, young: 1.0e7, poisson: 0}}\n";

}  // namespace

// u(L) = rho g L^2 / 2E; with masses lumped at the nodes linear elements are exact at the nodes, so what is left is the
// large deformation, of relative size u/L = 5e-5 here, and the tolerance.
TEST_CASE("a hanging bar comes to rest at rho g L^2 / 2E and stays there", "[oracle]") {
  const int n = GENERATE(4, 10, 30);
  Simulation bar(mesh::box("bar", {1, 0.1, 0.1}, {n, 1, 1}),
                 soft +
                     "parts: {bar: {material: m}}\n"
                     "fixed: [{set: bar_xmin, dofs: [x, y, z]}]\n"
                     "gravity: {vector: [1, 0, 0]}\nrelaxation: {tolerance: 1.0e-4}\n");
  const double steps = come_to_rest(bar, 1e-4);
  const double exact = 1000.0 * 1 * 1 / (2 * 1e7);
  const LocalIndex tip = bar.node(n);
  CHECK(bar.displacement(tip)[0] == Approx(exact).epsilon(3e-4));
  CHECK(steps < 2000);
  // a sudden load would swing by as much as the static displacement: with c = 100 at up to 0.1 * c u/L
  bar.step();
  const time::Ledger start = bar.ledger();
  CHECK(start.external == Approx(start.internal + start.hourglass + start.bulk).epsilon(1e-9));
  CHECK(start.internal == Approx(exact * exact * 1e7 * 0.01 * 4 / 3.0 / 2).epsilon(0.15 / n + 2e-3));
  double largest = 0;
  for (int i = 0; i < 1000; ++i) {
    bar.step();
    largest = std::max(largest, fastest(bar));
  }
  CHECK(largest < 2e-4 * 100 * exact);
  CHECK(bar.displacement(tip)[0] == Approx(exact).epsilon(3e-4));
  const time::Ledger ledger = bar.ledger();
  CHECK(ledger.total() == Approx(start.total()).margin(1e-9 * start.internal));
}

// Euler-Bernoulli with Timoshenko's shear: F L^3 / 3EI + F L / (5/6 G A).
TEST_CASE("a cantilever under a dead force at its tip bends as beam theory says", "[oracle]") {
  const int n = GENERATE(2, 4);
  const double L = 1, h = 0.1, E = 1e7, F = 1e-3;
  Simulation beam(mesh::box("beam", {L, h, h}, {10 * n, n, n}),
                  soft +
                      "parts: {beam: {material: m, element: hex8_bbar}}\n"
                      "fixed: [{set: beam_xmin, dofs: [x, y, z]}]\n"
                      "forces: [{set: beam_xmax, total: [0, 0, -1.0e-3]}]\nrelaxation: {}\n");
  come_to_rest(beam, 1e-3);
  const double exact = F * L * L * L / (3 * E * h * h * h * h / 12) + F * L / (5.0 / 6 * E / 2 * h * h);
  const LocalIndex tip = beam.node(10 * n);
  CHECK(-beam.displacement(tip)[2] == Approx(exact).epsilon(n == 2 ? 0.30 : 0.10));
}

TEST_CASE("an end that is driven stands still until the run begins", "[law]") {
  Simulation bar(mesh::box("bar", {1, 0.1, 0.1}, {8, 1, 1}), soft +
                                                                 "parts: {bar: {material: m}}\n"
                                                                 "prescribed: [{set: bar_xmin, dof: x, velocity: 3}]\n"
                                                                 "gravity: {vector: [1, 0, 0]}\nrelaxation: {}\n");
  come_to_rest(bar, 1e-3);
  CHECK(bar.displacement(bar.node(0))[0] == 0);
  bar.step();
  CHECK(bar.velocity(bar.node(0))[0] == 3);
}

TEST_CASE(
    "a block that rests on another under gravity begins at rest, with its weight between them from the first step",
    "[law]") {
  const std::string law = GENERATE("elastic, density: 1000, young: 1.0e7, poisson: 0.3",
                                   "j2, density: 1000, young: 1.0e7, poisson: 0.3, yield: 1.0e5, hardening: 1.0e6");
  const bool tied = GENERATE(false, true);
  mesh::Mesh both = mesh::box("low", {1, 1, 0.5}, {4, 4, 2});
  mesh::Mesh top = mesh::box("top", {0.6, 0.6, 0.5}, {3, 3, 2});
  mesh::place(top, 1, Vec3::UnitZ(), 0, {0.2, 0.2, 0.5});
  mesh::append(both, std::move(top), "");
  Simulation pile(std::move(both), "materials: {m: {model: " + law +
                                       "}}\nparts: {low: {material: m}, top: {material: m}}\n"
                                       "fixed: [{set: low_zmin, dofs: [x, y, z]}]\n"
                                       "contact: [{between: [low, top]" +
                                       (tied ? ", tied: true" : "") +
                                       "}]\n"
                                       "gravity: {vector: [0, 0, -10]}\nrelaxation: {tolerance: 1.0e-3}\n");
  come_to_rest(pile, 1e-3);
  const double sag = 1000 * 10 * 0.5 / 1e7, wave = 100;
  double largest = 0;
  for (int i = 0; i < 500; ++i) {
    pile.step();
    largest = std::max(largest, fastest(pile));
  }
  CHECK(largest < 0.02 * wave * sag);  // let go at once it would reach about wave * sag = 0.05
}
