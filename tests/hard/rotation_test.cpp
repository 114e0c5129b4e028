// SPDX-License-Identifier: Apache-2.0
// A cube that spins at 1e4 rad/s through many turns: no stress but the centrifugal one, no angular momentum lost.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr double rate = 1e4, edge = 0.01, young = 2e11;

void spin(int turns) {
  mesh::Mesh mesh = mesh::box("cube", {edge, edge, edge}, {2, 2, 2});
  mesh::place(mesh, 1, {0, 0, 1}, 0, {-edge / 2, -edge / 2, -edge / 2});
  Simulation cube(std::move(mesh),
                  "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\n"
                  "parts: {cube: {material: m, bulk: {linear: 0.5}}}\n"
                  "initial: [{part: cube, rotation: {axis: [1, 2, 2], rate: 1.0e4}}]\n");
  const Vec3 start = cube.angular_momentum();
  const double turn = 2 * std::numbers::pi / rate;
  double stress_early = 0, stress_late = 0;
  // mean of the pressure over a turn, from the trace (the same in any direction), and of its square
  const auto mean_stress = [&](double until) {
    double sum = 0;
    int count = 0;
    while (cube.state.time < until) {
      cube.step();
      for (int c = 0; c < 3; ++c) sum += cube.history(0, "stress", 0, c);
      ++count;
    }
    return sum / (3 * count);
  };
  mean_stress(20 * turn);
  stress_early = mean_stress(21 * turn);
  mean_stress((turns - 1) * turn);
  stress_late = mean_stress(turns * turn);
  CAPTURE(turns, stress_early, stress_late);
  const double centrifugal = 8000 * std::pow(rate * edge / 2, 2);  // rho v^2 of a face
  CHECK(stress_early > 0.01 * centrifugal);
  CHECK(stress_early < centrifugal);
  CHECK(std::abs(stress_late - stress_early) < 1e-6 * young);
  CHECK((cube.angular_momentum() - start).norm() < 1e-10 * start.norm());
}

}  // namespace

TEST_CASE("a cube at 1e4 rad/s keeps its angular momentum, its stress does not drift: 200 turns") {
  spin(200);
}

TEST_CASE("the same through 1e4 turns", "[.][long]") {
  spin(10000);
}
