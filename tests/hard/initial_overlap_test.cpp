// SPDX-License-Identifier: Apache-2.0
// Bodies that start a tenth of an element inside each other are let apart slowly (case E5 of the hard cases).
#include <catch2/catch.hpp>
#include <cmath>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr double h = 0.25, overlap = 0.1 * h, young = 100, wave_speed = 10;  // density 1, poisson 0
constexpr double area = 1;                                                   // cross-section of the bodies

/// A cube of 4 elements a side, and one of `other` a side that starts at `at`.
Simulation cubes(const Vec3& at, int other, const std::string& passes) {
  mesh::Mesh mesh = mesh::box("low", {1, 1, 1}, {4, 4, 4});
  mesh::Mesh high = mesh::box("high", {1, 1, 1}, {other, other, other});
  mesh::place(high, 1, {0, 0, 1}, 0, at);
  mesh::append(mesh, std::move(high));
  return {std::move(mesh),
          "materials: {m: {model: elastic, density: 1, young: 100, poisson: 0}}\n"
          "parts: {low: {material: m}, high: {material: m}}\n"
          "contact: [{between: all, initial_overlap: warn, passes: " +
              passes + "}]\n"};
}

struct Parting {
  double kinetic = 0, fastest = 0, drift = 0;
  bool apart = false;
};

/// Runs until no row is left, and on for the waves to settle.
Parting let_apart(Simulation& run, int steps) {
  Parting parting;
  double start = 0;
  for (int i = 0; i < steps; ++i) {
    run.step();
    const time::Ledger ledger = run.ledger();
    if (i == 0) start = ledger.total();
    parting.kinetic = std::max(parting.kinetic, ledger.kinetic);
    parting.drift = std::max(parting.drift, std::abs(ledger.total() - start));
    for (LocalIndex node = 0; node < run.nodes(); ++node)
      parting.fastest = std::max(parting.fastest, run.velocity(node).norm());
  }
  parting.apart = true;
  for (const contact::Row& row : run.contact->step.rows) parting.apart = parting.apart && row.gap > 0;
  return parting;
}

void check_parting(Simulation run) {
  const Parting parting = let_apart(run, 400);
  const double allowed = 0.01 * young * area * overlap * overlap / h;
  INFO("kinetic " << parting.kinetic << " of " << allowed << ", fastest " << parting.fastest / wave_speed
                  << " c, drift " << parting.drift);
  CHECK(parting.apart);
  CHECK(parting.kinetic > 0);
  CHECK(parting.kinetic <= allowed);
  CHECK(parting.fastest <= 1e-2 * wave_speed);
  CHECK(parting.drift <= 1e-10 * allowed);  // what recovery gives is booked
}

}  // namespace

TEST_CASE("E5: a flat patch that overlaps by a tenth of an element parts slowly", "[law]") {
  for (const std::string passes : {"one", "two"}) {
    check_parting(cubes({0, 0, 1 - overlap}, 4, passes));        // nodes on nodes
    check_parting(cubes({0.06, 0.03, 1 - overlap}, 5, passes));  // and beside them
  }
}

TEST_CASE("E5: two corners that overlap by a tenth of an element part slowly", "[law]") {
  const double edge = 1 - overlap;
  for (const std::string passes : {"one", "two"}) {
    check_parting(cubes({edge, edge, edge}, 4, passes));
    check_parting(cubes({edge, edge, 0.02}, 5, passes));
  }
}
