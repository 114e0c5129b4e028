// SPDX-License-Identifier: Apache-2.0
// Dead forces and tractions, given displacements and accelerations, against closed forms and the ledger.
#include <catch2/catch.hpp>
#include <cmath>

#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

const std::string steel =
    "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\nparts: {block: {material: m}}\n";

Vec3 sum_of_forces(const Simulation& s) {
  Vec3 sum = Vec3::Zero();
  for (LocalIndex i = 0; i < s.nodes(); ++i) sum += s.force(i);
  return sum;
}

/// A block whose nodes on the side xmax are spaced unevenly.
mesh::Mesh graded_block(std::array<int, 3> elements) {
  mesh::Mesh mesh = mesh::box("block", {3, 2, 1}, elements);
  for (Vec3& x : mesh.coordinates) x[1] = 2 * std::pow(x[1] / 2, 1.7);
  return mesh;
}

void check_momentum(const time::Ledger& ledger) {
  CHECK((ledger.momentum - ledger.impulse_given).norm() < 1e-12 * ledger.momentum_scale);
}

}  // namespace

TEST_CASE("a dead force acts on each node, a total on all together, a traction on the area of the start", "[oracle]") {
  const int n = GENERATE(1, 2, 5);
  const Vec3 value(3, -2, 7);
  const auto forces_of = [&](const std::string& load) {
    auto s = std::make_unique<Simulation>(graded_block({2, n, 3}), steel + load);
    s->step(1e-6);
    return s;
  };
  const auto each = forces_of("forces: [{set: block_xmax, force: [3, -2, 7]}]\n");
  CHECK((sum_of_forces(*each) - 4.0 * (n + 1) * value).norm() < 1e-12 * 4 * (n + 1));
  const auto total = forces_of("forces: [{set: block_xmax, total: [3, -2, 7]}]\n");
  CHECK((sum_of_forces(*total) - value).norm() < 1e-13);
  const auto traction = forces_of("traction: [{set: block_xmax, value: [3, -2, 7]}]\n");
  CHECK((sum_of_forces(*traction) - 2 * value).norm() < 1e-13);
  // spread by area: as a traction of the same resultant, node by node
  for (LocalIndex i = 0; i < total->nodes(); ++i)
    CHECK((2 * total->force(i) - traction->force(i)).norm() < 1e-14 * value.norm());
  for (const auto* s : {each.get(), total.get(), traction.get()}) check_momentum(s->ledger());
}

TEST_CASE("a total over a set of nodes finds the faces that it has all nodes of", "[oracle]") {
  Simulation s(mesh::box("block", {2, 1, 1}, {2, 2, 2}), steel +
                                                             "sets: {end: {part: block, box: [[2, 0, 0], [2, 1, 1]]}}\n"
                                                             "forces: [{set: end, total: [0, 0, -8]}]\n");
  s.step(1e-6);
  CHECK(sum_of_forces(s)[2] == Approx(-8).epsilon(1e-14));
  for (LocalIndex i = 0; i < s.nodes(); ++i)
    if (s.position(i)[0] < 1.5) CHECK(s.force(i).norm() < 1e-6);
}

TEST_CASE("dead loads keep their direction while the body turns, follow their curve, and their work is booked",
          "[law]") {
  Simulation s(mesh::box("block", {1, 1, 1}, {2, 2, 2}),
               steel +
                   "curves: {ramp: [[0, 0], [1.0e-3, 1]]}\n"
                   "initial: [{part: block, rotation: {axis: [0, 0, 1], point: [0.5, 0.5, 0.5], rate: 300}}]\n"
                   "forces: [{part: block, force: [5.0e6, 0, 1.0e6], curve: ramp}]\n");
  s.step();
  const double start = s.ledger().total();
  Vec3 impulse = Vec3::Zero();
  while (s.state.time < 2e-3) s.step();
  const time::Ledger ledger = s.ledger();
  CHECK(ledger.total() == Approx(start).epsilon(1e-11));
  CHECK(ledger.external > 0.005 * ledger.kinetic);
  const double t = s.state.time - 0.5 * s.report.dt;
  impulse = 27 * (t - 0.5e-3) * Vec3(5e6, 0, 1e6);
  CHECK((ledger.impulse_given - impulse).norm() < 1e-3 * impulse.norm());
  CHECK(std::abs(ledger.impulse_given[1]) < 1e-12 * impulse.norm());
}

TEST_CASE("a displacement is what its curve says at the times of all steps", "[oracle]") {
  const double scale = GENERATE(1.0, -2.5);
  Simulation s(mesh::box("block", {1, 0.2, 0.2}, {5, 1, 1}),
               steel +
                   "curves: {push: [[0, 0], [2.0e-4, 1.0e-3], [3.1e-4, -2.0e-3], [1, -2.0e-3]]}\n"
                   "prescribed: [{set: block_xmin, dof: x, displacement: push, scale: " +
                   std::to_string(scale) + "}]\n");
  const auto given = [&](double t) {
    if (t < 2e-4) return scale * 1e-3 * t / 2e-4;
    return t < 3.1e-4 ? scale * (1e-3 - 3e-3 * (t - 2e-4) / 1.1e-4) : -2e-3 * scale;
  };
  const LocalIndex end = s.node(0);
  double worst = 0;
  while (s.state.time < 5e-4) {
    s.step();
    worst = std::max(worst, std::abs(s.displacement(end)[0] - given(s.state.time)));
  }
  CHECK(worst < 1e-15);
  const time::Ledger ledger = s.ledger();
  CHECK(ledger.external == Approx(ledger.kinetic + ledger.internal + ledger.hourglass + ledger.bulk).epsilon(1e-9));
  check_momentum(ledger);
}

TEST_CASE("an acceleration changes the initial velocity by its integral, exactly for a curve of straight pieces",
          "[oracle]") {
  const double start = GENERATE(0.0, 12.0);
  Simulation s(mesh::box("block", {1, 0.2, 0.2}, {5, 1, 1}),
               steel +
                   "curves: {pulse: [[1.0e-4, 0], [1.5e-4, 4.0e4], [2.5e-4, -1.0e4], [3.0e-4, 0]]}\n"
                   "initial: [{part: block, velocity: [" +
                   std::to_string(start) +
                   ", 0, 0]}]\n"
                   "prescribed: [{part: block, dof: x, acceleration: pulse, scale: 2}]\n");
  const auto gained = [](double t) {  // integral of the pulse
    double sum = 0;
    const double at[] = {1e-4, 1.5e-4, 2.5e-4, 3e-4}, value[] = {0, 4e4, -1e4, 0};
    for (int k = 0; k < 3; ++k) {
      const double h = at[k + 1] - at[k], x = std::min(std::max(t - at[k], 0.0), h);
      sum += value[k] * x + 0.5 * (value[k + 1] - value[k]) * x * x / h;
    }
    return 2 * sum;
  };
  double worst = 0;
  while (s.state.time < 4e-4) {
    s.step();
    worst = std::max(worst, std::abs(s.velocity(s.node(0))[0] - start - gained(s.state.time - 0.5 * s.state.dt)));
  }
  CHECK(worst < 1e-12);
  const time::Ledger ledger = s.ledger();
  CHECK((ledger.momentum - ledger.mass * Vec3(start, 0, 0) - ledger.impulse_given).norm() <
        1e-12 * ledger.momentum_scale);
}
