// SPDX-License-Identifier: Apache-2.0
// E20 for a tied pair: two cubes of meshes that do not match, held together while they spin.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
#include "tests/support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr double rate = 1e4;  // [rad/s]

/// gap: between the cubes, which the tie keeps [m].
Simulation spinning_pair(double gap = 0) {
  mesh::Mesh mesh = mesh::box("left", {0.01, 0.01, 0.01}, {2, 2, 2});
  mesh::Mesh right = mesh::box("right", {0.01, 0.01, 0.01}, {3, 3, 3});
  for (Vec3& x : right.coordinates) x.x() += 0.01 + gap;
  mesh::append(mesh, std::move(right));
  return {std::move(mesh),
          "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\n"
          "parts: {left: {material: m}, right: {material: m}}\n"
          "initial:\n"
          "  - {part: left, rotation: {axis: [0, 0, 1], point: [0.01, 0.005, 0.005], rate: 1.0e4}}\n"
          "  - {part: right, rotation: {axis: [0, 0, 1], point: [0.01, 0.005, 0.005], rate: 1.0e4}}\n"
          "contact: [{between: [left, right], tied: true, tolerance: 1.0e-10, max_iterations: 500}]\n"};
}

}  // namespace

TEST_CASE("E20: a tied pair at 1e4 rad/s keeps its angular momentum and stays together: 20 turns") {
  Simulation pair = spinning_pair();
  pair.step();
  const Vec3 before = pair.angular_momentum();
  const double turns = 20, end = turns * 2 * std::numbers::pi / rate;
  while (pair.state.time < end) pair.step();
  CHECK(std::ranges::count_if(pair.contact->rows(), [](const contact::Row& row) { return std::isinf(row.friction); }) ==
        16);  // the nodes of the finer side
  const double change = (pair.angular_momentum() - before).norm() / before.norm();
  CAPTURE(change, pair.contact->statistics().iterations);
  CHECK(change <= 1e-10);
  double crept = 0;
  for (const contact::Row& row : pair.contact->rows())
    if (std::isinf(row.friction)) crept = std::max(crept, std::abs(row.gap));
  CAPTURE(crept);
  CHECK(crept <= 1e-6 * 0.01);
}

TEST_CASE("a tie across a gap gives no energy while the pair turns: 10 turns") {
  for (const double gap : {2e-4, -2e-4, 1e-3}) {
    Simulation pair = spinning_pair(gap);
    pair.step();
    const double start = pair.ledger().total();
    double taken = 0;
    const double end = 10 * 2 * std::numbers::pi / rate;
    while (pair.state.time < end) {
      for (int i = 0; i < 100; ++i) pair.step();
      const time::Ledger now = pair.ledger();
      CAPTURE(gap, pair.state.time, now.contact + now.friction, start);
      CHECK(now.contact + now.friction >= taken - 1e-6 * start);
      taken = now.contact + now.friction;
    }
  }
}
