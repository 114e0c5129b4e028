// SPDX-License-Identifier: Apache-2.0
// Loads and given motions against closed forms, with what the ledger books for them.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

const std::string steel = "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\n";

mesh::Mesh distorted_block(double shift) {
  mesh::Mesh mesh = mesh::box("block", {3, 2, 2}, {3, 2, 2});
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> noise(-shift, shift);
  for (Vec3& x : mesh.coordinates) x += Vec3(noise(engine), noise(engine), noise(engine));
  return mesh;
}

}  // namespace

TEST_CASE("free fall is exact in any step, and gravity's work and impulse are booked", "[oracle]") {
  const Vec3 gravity(0.3, 0, -9.81), start(2, 0, 5);
  Simulation block(distorted_block(0.2), steel +
                                             "parts: {block: {material: m}}\n"
                                             "gravity: {vector: [0.3, 0, -9.81]}\n"
                                             "initial: [{part: block, velocity: [2, 0, 5]}]\n");
  for (int i = 0; i < 300; ++i) block.step(1e-5 * (1 + i % 3));
  const double t = block.state.time;
  const Vec3 exact = t * start + 0.5 * t * t * gravity;
  for (LocalIndex i = 0; i < block.nodes(); ++i) CHECK((block.displacement(i) - exact).norm() < 1e-12 * exact.norm());
  block.step(1e-5);
  const time::Ledger ledger = block.ledger();
  const double mass = ledger.mass, dt_next = 1e-5;
  CHECK(mass == Approx(8000 * 12).epsilon(0.2));
  CHECK(ledger.external == Approx(mass * gravity.dot(exact)).epsilon(1e-2));  // of first order where steps jump
  CHECK(ledger.external == Approx(ledger.kinetic - 0.5 * mass * start.squaredNorm()).epsilon(1e-9));
  CHECK((ledger.momentum - mass * (start + gravity * (t + dt_next / 2))).norm() < 1e-12 * ledger.momentum_scale);
  CHECK((ledger.impulse_given - mass * gravity * (t + dt_next / 2)).norm() < 1e-12 * ledger.momentum_scale);
  CHECK(std::abs(ledger.internal) < 1e-12 * ledger.kinetic);
}

TEST_CASE("pressure on a closed surface of warped faces has no resultant", "[law]") {
  Simulation block(distorted_block(0.3), steel +
                                             "parts: {block: {material: m}}\n"
                                             "pressure:\n"
                                             "  - {set: block_xmin, value: 1.0e6}\n"
                                             "  - {set: block_xmax, value: 1.0e6}\n"
                                             "  - {set: block_ymin, value: 1.0e6}\n"
                                             "  - {set: block_ymax, value: 1.0e6}\n"
                                             "  - {set: block_zmin, value: 1.0e6}\n"
                                             "  - {set: block_zmax, value: 1.0e6}\n");
  block.step(1e-6);
  Vec3 force = Vec3::Zero();
  double scale = 0;
  for (LocalIndex i = 0; i < block.nodes(); ++i) {
    const Vec3 f = block.force(i);
    force += f;
    scale += f.norm();
  }
  CHECK(scale > 1e6);
  CHECK(force.norm() < 1e-14 * scale);
  CHECK(block.ledger().impulse_given.norm() < 1e-14 * 1e-6 * scale);
}

TEST_CASE("pressure on one face pushes inwards with value times area", "[oracle]") {
  Simulation block(mesh::box("block", {3, 2, 2}, {3, 2, 2}), steel +
                                                                 "parts: {block: {material: m}}\n"
                                                                 "pressure: [{set: block_xmax, value: 1.0e6}]\n");
  block.step(1e-6);
  Vec3 force = Vec3::Zero();
  for (LocalIndex i = 0; i < block.nodes(); ++i) force += block.force(i);
  CHECK((force - Vec3(-4e6, 0, 0)).norm() < 1e-8);
}

// A laterally free bar of nu = 0: behind the front all moves with the given velocity, the end force is rho c A v.
TEST_CASE("a prescribed velocity drives the end of a bar exactly, and its work is what the bar has gained",
          "[oracle]") {
  const double speed = 10, area = 1e-4, wave_speed = 5000;
  Simulation bar(mesh::box("bar", {1, 0.01, 0.01}, {100, 1, 1}),
                 "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0}}\n"
                 "parts: {bar: {material: m}}\n"
                 "curves: {hold: [[0, 1], [1, 1]]}\n"
                 "prescribed: [{set: bar_xmin, dof: x, velocity: hold, scale: 10}]\n");
  while (bar.state.time < 1.5e-4) bar.step();
  const double t = bar.state.time;
  const LocalIndex end = bar.node(0);
  CHECK(bar.displacement(end)[0] == Approx(speed * t).epsilon(1e-12));
  CHECK(bar.velocity(end)[0] == speed);
  CHECK(bar.velocity(bar.node(30))[0] == Approx(speed).epsilon(2e-2));
  CHECK(bar.velocity(bar.node(90))[0] == Approx(0).margin(1e-3 * speed));
  bar.step();
  const time::Ledger ledger = bar.ledger();
  const double impulse = 8000 * wave_speed * area * speed * t;
  CHECK(ledger.external == Approx(impulse * speed).epsilon(1e-2));
  CHECK(ledger.external == Approx(ledger.kinetic + ledger.internal + ledger.hourglass + ledger.bulk).epsilon(1e-10));
  CHECK(ledger.impulse_given[0] == Approx(impulse).epsilon(1e-2));
  CHECK((ledger.impulse_given - ledger.momentum).norm() < 1e-12 * ledger.momentum_scale);
}
