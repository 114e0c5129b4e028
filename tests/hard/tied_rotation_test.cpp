// SPDX-License-Identifier: Apache-2.0
// E20 for a tied pair: two cubes of meshes that do not match, held together while they spin.
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

Simulation spinning_pair() {
  mesh::Mesh mesh = mesh::box("left", {0.01, 0.01, 0.01}, {2, 2, 2});
  mesh::Mesh right = mesh::box("right", {0.01, 0.01, 0.01}, {3, 3, 3});
  for (Vec3& x : right.coordinates) x.x() += 0.01;
  mesh::append(mesh, std::move(right));
  return {std::move(mesh),
          "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\n"
          "parts: {left: {material: m}, right: {material: m}}\n"
          "initial:\n"
          "  - {part: left, rotation: {axis: [0, 0, 1], point: [0.01, 0.005, 0.005], rate: 1.0e4}}\n"
          "  - {part: right, rotation: {axis: [0, 0, 1], point: [0.01, 0.005, 0.005], rate: 1.0e4}}\n"
          "contact: [{between: [left, right], tied: true}]\n"};
}

}  // namespace

TEST_CASE("E20: a tied pair at 1e4 rad/s keeps its angular momentum and stays together: 20 turns") {
  Simulation pair = spinning_pair();
  pair.step();
  const Vec3 before = pair.angular_momentum();
  const double turns = 20, end = turns * 2 * std::numbers::pi / rate;
  double most_active = 0;
  while (pair.state.time < end) {
    pair.step();
    most_active = std::max(most_active, static_cast<double>(pair.contact->rows().size()));
  }
  CHECK(most_active == 16);  // the nodes of the finer side
  const double change = (pair.angular_momentum() - before).norm() / before.norm();
  CAPTURE(change, pair.contact->statistics().iterations);
  CHECK(change <= 1e-10);
  double crept = 0;
  for (const contact::Row& row : pair.contact->rows()) crept = std::max(crept, std::abs(row.gap));
  CAPTURE(crept);
  CHECK(crept <= 1e-6 * 0.01);
}
