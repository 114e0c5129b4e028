// SPDX-License-Identifier: Apache-2.0
// The size of steps, and what the ledger says of them.
#include "time/step.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

Simulation free_box(const std::string& more = "") {
  return {
      mesh::box("box", {1, 1, 1}, {2, 2, 2}),
      "materials: {m: {model: elastic, density: 1, young: 100, poisson: 0.3}}\nparts: {box: {material: m}}\n" + more};
}

}  // namespace

TEST_CASE("the step grows by 2 % at most, and is never above the stable one") {
  Simulation box = free_box();
  box.step();
  const double stable = box.state.dt;
  CHECK(stable == Approx(0.9 / box.report.rate).epsilon(1e-12));
  box.step(0.5 * stable);
  double before = 0.5 * stable;
  int grown = 0;
  for (int n = 0; n < 60; ++n) {
    box.step();
    CHECK(box.state.dt <= 1.02 * before * (1 + 1e-15));
    CHECK(box.state.dt >= before);
    CHECK(box.state.dt <= stable * (1 + 1e-12));
    grown += box.state.dt > before ? 1 : 0;
    before = box.state.dt;
  }
  CHECK(grown == 35);  // 1.02^35 > 2 / 1.02: the next one would pass it
  CHECK(before > stable / 1.02);
}

TEST_CASE("the step falls at once where the stable one does") {
  Simulation box = free_box();
  box.step();
  const double before = box.state.dt;
  box.control.largest = 0.3 * before;
  box.step();
  CHECK(box.state.dt == Approx(0.3 * before).epsilon(1e-12));
}

TEST_CASE("forces act over half of the first step, then over the mean of the steps around them") {
  Simulation box = free_box("gravity: {vector: [0, 0, -10]}\n");
  double before = 0;
  for (const double dt : {1e-3, 2e-3, 1.5e-3}) {
    const double v = box.velocity(0).z();
    box.step(dt);
    CHECK(box.report.dt_mean == Approx(0.5 * (before + dt)).epsilon(1e-14));
    CHECK(box.velocity(0).z() - v == Approx(-10 * 0.5 * (before + dt)).epsilon(1e-12));
    before = dt;
  }
}

TEST_CASE("the ledger's kinetic energy is 1/2 m v(n - 1/2) . v(n + 1/2), and the sum of all terms stands still") {
  Simulation box = free_box("initial: [{part: box, velocity: [1, 2, 0], rotation: {axis: [1, 1, 0], rate: 3}}]\n");
  box.step();
  const double start = box.ledger().total();
  for (int n = 0; n < 20; ++n) {
    std::vector<Vec3> before;
    for (LocalIndex i = 0; i < box.nodes(); ++i) before.push_back(box.velocity(i));
    box.step();
    double kinetic = 0;
    for (LocalIndex i = 0; i < box.nodes(); ++i)
      kinetic += 0.5 * box.mass(i) * before[static_cast<std::size_t>(i)].dot(box.velocity(i));
    CHECK(box.ledger().kinetic == Approx(kinetic).epsilon(1e-13));
    CHECK(box.ledger().total() == Approx(start).epsilon(1e-12));
  }
}

TEST_CASE("a driven node has the velocity of its curve at the half step, exactly") {
  Simulation box = free_box(
      "sets: {end: {box: [[-1, -1, 0.99], [2, 2, 1.01]]}}\ncurves: {c: [[0, 1], [1, 3]]}\n"
      "prescribed: [{set: end, dof: x, velocity: c}]\nfixed: [{set: end, dofs: [y, z]}]\n");
  for (int n = 0; n < 10; ++n) {
    const double t = box.state.time;
    box.step();
    int driven = 0;
    for (LocalIndex i = 0; i < box.nodes(); ++i) {
      if (box.model.reference[static_cast<std::size_t>(i)][2] < 0.99) continue;
      ++driven;
      CHECK(box.velocity(i).x() == Approx(1 + 2 * (t + 0.5 * box.report.dt)).epsilon(1e-15));
      CHECK(box.velocity(i).tail<2>().norm() == 0);
    }
    CHECK(driven == 9);
  }
}
