// SPDX-License-Identifier: Apache-2.0
// E11: a block that sticks while its load along the plane swings up to 99 % of the limit of friction.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

struct Swing {
  double creep = 0;   ///< of the block's middle a cycle, once it has settled [m]
  double travel = 0;  ///< to and fro within a cycle [m]
};

Swing swing(int cycles) {
  constexpr double period = 0.01, rest = 0.02, pi = 3.14159265358979;
  // pressed by 1 kPa from above; the load along the plane is a body force, density x height x acceleration of its area
  constexpr double pressure = 1000, density = 1000, height = 0.02, friction = 0.5;
  std::string points = fmt::format("[0, 0], [{}, 0]", rest);
  constexpr int parts = 24;
  for (int k = 0; k < cycles * parts; ++k)
    points += fmt::format(", [{:.9g}, {:.9g}]", rest + (k + 1) * period / parts, std::sin(2 * pi * (k + 1) / parts));
  Simulation scene(mesh::box("block", {0.1, 0.1, height}, {4, 4, 2}),
                   "materials: {m: {model: elastic, density: 1000, young: 1.0e7, poisson: 0.3}}\n"
                   "parts: {block: {material: m}}\ndamping: {alpha: 1000}\n"
                   "rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}]\n"
                   "curves: {press: [[0, 0], [0.01, 1]], swing: [" +
                       points + "]}\n" +
                       fmt::format("pressure: [{{set: block_zmax, value: {}, curve: press}}]\n", pressure) +
                       fmt::format("gravity: {{vector: [{}, 0, 0], curve: swing}}\n",
                                   0.99 * friction * pressure / (density * height)));
  const auto middle = [&] {
    double sum = 0;
    for (LocalIndex n = 0; n < scene.nodes(); ++n) sum += scene.displacement(n).x();
    return sum / scene.nodes();
  };
  Swing result;
  const int settled = cycles / 4;
  double before = 0, high = -1, low = 1;
  for (int k = 0; k < cycles; ++k) {
    while (scene.state.time < rest + (k + 1) * period) {
      scene.step();
      if (k > settled) {
        high = std::max(high, middle());
        low = std::min(low, middle());
      }
    }
    if (k == settled) before = middle();
  }
  result.creep = (middle() - before) / (cycles - 1 - settled);
  result.travel = high - low;
  return result;
}

}  // namespace

TEST_CASE("a load along the plane that swings to 99 % of the limit does not make a block walk", "[law]") {
  const Swing found = swing(100);
  CAPTURE(found.creep, found.travel);
  CHECK(found.travel > 1e-6);
  CHECK(std::abs(found.creep) <= 1e-9);
}

TEST_CASE("nor in ten thousand cycles", "[.][long][law]") {
  const Swing found = swing(10000);
  CAPTURE(found.creep, found.travel);
  CHECK(std::abs(found.creep) <= 1e-9);
}
