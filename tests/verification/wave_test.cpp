// SPDX-License-Identifier: Apache-2.0
// Vibration of a bar of ten elements against the exact solution of its difference equations.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr int elements = 10;
constexpr double length = 1, wave_speed = 5000, h = length / elements;
constexpr double pi = std::numbers::pi;

/// Fixed at x = 0, free at x = 1, moving in its k-th mode with the largest velocity `amplitude` at its end; nu = 0
/// keeps it one-dimensional.
Simulation bar(int k, double amplitude, const std::string& element = "hex8") {
  Simulation bar(mesh::box("bar", {length, h, h}, {elements, 1, 1}),
                 "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0}}\n"
                 "parts: {bar: {material: m, bulk: {linear: 0, quadratic: 0}, element: " +
                     element +
                     "}}\n"
                     "fixed: [{set: bar_xmin, dofs: [x]}]\n");
  for (LocalIndex i = 0; i < bar.nodes(); ++i)
    bar.state.nodes[static_cast<std::size_t>(i)].v[0] =
        amplitude * std::sin((2 * k - 1) * pi / 2 * bar.position(i)[0] / length);
  return bar;
}

double tip(const Simulation& bar) {
  return bar.displacement(bar.node(elements))[0];
}

/// Frequency of the k-th mode with lumped masses.
double exact_frequency(int k) {
  return 2 * wave_speed / h * std::sin((2 * k - 1) * pi / (4 * elements));
}

/// Central differences shift omega to this.
double shifted(double omega, double dt) {
  return 2 / dt * std::asin(omega * dt / 2);
}

/// From the time of a zero crossing after at least `periods`.
double measured_frequency(Simulation& bar, double dt, double expected, int periods) {
  double before = 0;
  const double sign = std::copysign(1.0, bar.velocity(bar.node(elements))[0]);
  bar.step(dt);
  for (;;) {
    const double now = sign * tip(bar);
    if (before < 0 && now >= 0 && bar.state.time * expected > 2 * pi * (periods - 0.5)) {
      const double phase = std::atan2(before * std::sin(expected * dt), now - before * std::cos(expected * dt));
      return 2 * pi * periods / (bar.state.time_before - phase / expected);
    }
    before = now;
    bar.step(dt);
  }
}

}  // namespace

TEST_CASE("discrete wave: three modes of a fixed-free bar have the frequencies of central differences to 1e-8",
          "[oracle]") {
  const double dt = 0.9 * h / wave_speed;
  // the same by hand: omega of the difference equations in space, and of those in time at this step
  const double table[3][2] = {{7845.909572784494, 7852.4444877019605},
                              {23344.536385590545, 23519.787551257214},
                              {38268.343236508976, 39068.40938391149}};
  for (int k = 1; k <= 3; ++k) {
    const double omega = shifted(exact_frequency(k), dt);
    CHECK(exact_frequency(k) == Approx(table[k - 1][0]).epsilon(1e-12));
    CHECK(omega == Approx(table[k - 1][1]).epsilon(1e-12));
    Simulation vibrating = bar(k, 1e-6 * wave_speed);  // largest strain about 1e-6
    CHECK(measured_frequency(vibrating, dt, omega, 100) == Approx(omega).epsilon(1e-8));
  }
}

TEST_CASE("a smooth vibration converges with order 2 in the step, for every hexahedron", "[oracle]") {
  const double omega = exact_frequency(1), end = 2.3 / omega, speed = 1e-7 * wave_speed;
  for (const std::string element : {"hex8", "hex8_full", "hex8_bbar"}) {
    double error[3];
    for (int i = 0; i < 3; ++i) {
      const int steps = 40 << i;
      Simulation vibrating = bar(1, speed, element);
      vibrating.steps(steps, end / steps);
      error[i] = std::abs(tip(vibrating) - speed / omega * std::sin(omega * end)) * omega / speed;
    }
    CAPTURE(element, error[0], error[1], error[2]);
    CHECK(error[2] < 1e-4);
    CHECK(std::log2(error[0] / error[1]) == Approx(2).margin(0.05));
    CHECK(std::log2(error[1] / error[2]) == Approx(2).margin(0.05));
  }
}
