// SPDX-License-Identifier: Apache-2.0
// Conservation in a free body that tumbles, vibrates and flows: the ledger, momentum, the stored energy of rubber.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

const std::string plastic =
    "materials: {m: {model: j2, density: 8000, young: 2.0e11, poisson: 0.3, yield: 4.0e8, hardening: 1.0e9}}\n";
const std::string rubber = "materials: {m: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.4}}\n";

/// Stored energy of the rubber by 2x2x2 points, from the formula of the law: independent of the element's own code.
double stored_energy(const Simulation& block, double lambda, double mu) {
  constexpr double at = 0.57735026918962576451;
  constexpr double corner[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  double energy = 0;
  for (LocalIndex e = 0; e < block.model.blocks[0].count; ++e)
    for (const auto& point : corner) {
      Mat3 dX = Mat3::Zero(), dx = Mat3::Zero();
      for (int c = 0; c < 8; ++c) {
        Vec3 slope;
        for (int j = 0; j < 3; ++j) {
          const int k = (j + 1) % 3, l = (j + 2) % 3;
          slope[j] = 0.125 * corner[c][j] * (1 + corner[c][k] * at * point[k]) * (1 + corner[c][l] * at * point[l]);
        }
        const LocalIndex node = block.model.blocks[0].corner_node(e, c);
        dX += block.model.mesh.coordinates[static_cast<std::size_t>(node)] * slope.transpose();
        dx += block.position(node) * slope.transpose();
      }
      const Mat3 F = dx * dX.inverse();
      const double J = std::log(F.determinant());
      energy += dX.determinant() * (mu / 2 * (F.squaredNorm() - 3) - mu * J + lambda / 2 * J * J);
    }
  return energy;
}

/// A block thrown with a spin, all nodes shaken on top.
Simulation shaken(const std::string& material, const std::string& element, double spin, double shake) {
  Simulation block(mesh::box("block", {1, 1, 1}, {3, 3, 3}),
                   material + "parts: {block: {material: m, element: " + element + "}}\n");
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> noise(-shake, shake);
  for (LocalIndex i = 0; i < block.nodes(); ++i) {
    const Vec3 v = Vec3(30, 0, 0) + spin * Vec3(1, 2, -1).cross(block.position(i)) +
                   Vec3(noise(engine), noise(engine), noise(engine));
    Eigen::Map<Vec3>(block.state.nodes[static_cast<std::size_t>(i)].v) = v;
  }
  return block;
}

void check_conservation(Simulation& block, int steps) {
  block.step();
  const time::Ledger start = block.ledger();
  const Vec3 spin_start = block.angular_momentum();
  for (int i = 0; i < steps; ++i) {
    block.step();
    if (i % 50 != 0) continue;
    const time::Ledger now = block.ledger();
    CHECK(now.total() == Approx(start.total()).epsilon(1e-10));
    CHECK((now.momentum - start.momentum).norm() < 1e-12 * start.momentum_scale);
    CHECK((block.angular_momentum() - spin_start).norm() < 1e-11 * spin_start.norm());
  }
}

}  // namespace

TEST_CASE("a free block that tumbles and flows keeps momentum, angular momentum and the ledger's sum", "[law]") {
  for (const std::string element : {"hex8", "hex8_full", "hex8_bbar"}) {
    CAPTURE(element);
    Simulation block = shaken(plastic, element, 20, 150);
    check_conservation(block, 500);
    const time::Ledger ledger = block.ledger();
    double plastic_strain = 0;
    for (LocalIndex e = 0; e < 27; ++e)
      plastic_strain = std::max(plastic_strain, block.history(0, "plastic_strain", e, 0));
    CHECK(plastic_strain > 0.005);
    CHECK(ledger.internal > 0);
    CHECK(ledger.bulk > 0);
    CHECK(ledger.hourglass >= 0);
  }
}

TEST_CASE("a free block of rubber that tumbles at large strain keeps them too", "[law]") {
  for (const std::string element : {"hex8", "hex8_full", "hex8_bbar"}) {
    CAPTURE(element);
    Simulation block = shaken(rubber, element, 3, 8);
    check_conservation(block, 500);
  }
}

TEST_CASE("what the ledger calls internal energy is the stored energy of rubber, of second order in the step",
          "[oracle]") {
  const double young = 1e6, poisson = 0.4;
  const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)), mu = young / (2 * (1 + poisson));
  const double end = 0.05;  // at about 30 m/s of sound in bars: several transits
  double error[3];
  for (int i = 0; i < 3; ++i) {
    const int steps = 200 << i;
    Simulation block(mesh::box("block", {1, 1, 1}, {2, 2, 2}),
                     rubber + "parts: {block: {material: m, element: hex8_full, bulk: {linear: 0, quadratic: 0}}}\n");
    for (LocalIndex n = 0; n < block.nodes(); ++n) {  // smooth: bending, stretch and spin
      const Vec3 x = block.position(n);
      Eigen::Map<Vec3>(block.state.nodes[static_cast<std::size_t>(n)].v) =
          Vec3(6 * (x[0] - 0.5) * (x[1] - 0.5), 4 * x[0] * x[0] - 3 * x[2], -5 * x[1] * x[2]);
    }
    block.steps(steps, end / steps);
    const double exact = stored_energy(block, lambda, mu);
    block.step(end / steps);
    error[i] = std::abs(block.ledger().internal / exact - 1);
    CHECK(exact > 0.01 * block.ledger().kinetic);
  }
  CAPTURE(error[0], error[1], error[2]);
  CHECK(error[2] < 1e-3);
  CHECK(std::log2(error[0] / error[1]) == Approx(2).margin(0.2));
  CHECK(std::log2(error[1] / error[2]) == Approx(2).margin(0.2));
}
