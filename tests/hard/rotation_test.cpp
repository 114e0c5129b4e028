// SPDX-License-Identifier: Apache-2.0
// A cube that spins at 1e4 rad/s through many turns: no stress but the centrifugal one, no angular momentum lost.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr double rate = 1e4, edge = 0.01, young = 2e11, density = 8000;

/// The rotation of the body: polar part of the best affine map from reference to current positions.
Mat3 turned(const Simulation& cube) {
  Mat3 sum = Mat3::Zero();  // the reference positions' own moments are those of a cube, a multiple of the identity
  for (LocalIndex i = 0; i < cube.nodes(); ++i)
    sum += cube.mass(i) * cube.position(i) * (cube.position(i) - cube.displacement(i)).transpose();
  const Eigen::JacobiSVD<Mat3> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

/// Mean stress of the elements, seen by the body.
Mat3 stress_of(const Simulation& cube) {
  Mat3 sum = Mat3::Zero();
  const LocalIndex elements = cube.model.blocks[0].count;
  for (LocalIndex e = 0; e < elements; ++e) {
    const auto s = [&](int component) { return cube.history(0, "stress", e, component); };
    sum += Mat3{{s(0), s(3), s(5)}, {s(3), s(1), s(4)}, {s(5), s(4), s(2)}} / elements;
  }
  const Mat3 rotation = turned(cube);
  return rotation.transpose() * sum * rotation;
}

/// Virial theorem for lumped masses: the mean stress of a body that turns about `axis` without deforming further. A
/// cube of two elements an edge has node masses 1/4, 1/2, 1/4 at -edge/2, 0, edge/2.
Mat3 centrifugal(const Vec3& axis) {
  return density * std::pow(rate * edge, 2) / 8 * (Mat3::Identity() - axis * axis.transpose());
}

void spin(int turns) {
  mesh::Mesh mesh = mesh::box("cube", {edge, edge, edge}, {2, 2, 2});
  mesh::place(mesh, 1, {0, 0, 1}, 0, {-edge / 2, -edge / 2, -edge / 2});
  Simulation cube(std::move(mesh),
                  "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\n"
                  "parts: {cube: {material: m, bulk: {linear: 0.5}}}\n"
                  "initial: [{part: cube, rotation: {axis: [1, 2, 2], rate: 1.0e4}}]\n");
  const Vec3 start = cube.angular_momentum();
  const double turn = 2 * std::numbers::pi / rate;
  const auto go_until = [&](double until) {
    while (cube.state.time < until) cube.step();
  };
  const auto mean_stress_over_turn_to = [&](double until) {
    go_until(until - turn);
    Mat3 sum = Mat3::Zero();
    int count = 0;
    for (; cube.state.time < until; ++count) {
      cube.step();
      sum += stress_of(cube);
    }
    return Mat3(sum / count);
  };
  const Mat3 early = mean_stress_over_turn_to(21 * turn);
  const Mat3 late = mean_stress_over_turn_to(turns * turn);
  const Mat3 exact = centrifugal(Vec3(1, 2, 2) / 3);
  const auto largest = [](const Mat3& m) { return m.cwiseAbs().maxCoeff(); };
  const double drift = largest(late - early) / young, away = largest(late - exact) / young;
  const double momentum = (cube.angular_momentum() - start).norm() / start.norm();
  std::printf(
      "%d turns, %g steps: stress drift %.2e E, off the centrifugal one %.2e E (which is %.2e E), "
      "angular momentum %.2e\n",
      turns, cube.state.step, drift, away, largest(exact) / young, momentum);
  CHECK(drift < 1e-6);
  CHECK(away < 1e-6);
  CHECK(momentum < 1e-10);
}

}  // namespace

TEST_CASE("a cube at 1e4 rad/s keeps its angular momentum, its stress does not drift: 200 turns", "[oracle]") {
  spin(200);
}

TEST_CASE("the same through 1e4 turns", "[.][long][oracle]") {
  spin(10000);
}
