// SPDX-License-Identifier: Apache-2.0
// Rotations of nodes whose moments are given: exact values of the scheme, no elements.
#include "time/rotations.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

using namespace brunt;

namespace {

/// One node that turns, with moments of elements and of loads.
struct Node {
  model::Model model;
  model::State state;
  model::Scratch scratch;

  explicit Node(double inertia) {
    model.mesh.node_gid = {0};
    model.turning = {0};
    model.loads.gravity = Vec3(0, 0, 1);  // a scene with loads
    state.rotations.resize(1);
    state.rotations[0] = {{0, 0, 0}, inertia, {0, 0, 0, 1}};
    state.rotation_accounts.resize(1);
    scratch.moment.assign(1, Quad{});
    scratch.moment_load.assign(1, Quad{});
    scratch.rate_before.assign(1, Quad{});
  }
  void hold(const Mat3& free, std::int32_t drive_of_z = -1) {
    model.rotation_supports.nodes.push_back({.node = 0, .free = free});
    model.rotation_supports.drive.push_back({-1, -1, drive_of_z});
  }
  void step(double dt, double drag = 0) {
    time::advance_rotations(model, state, scratch, {.dt = dt, .dt_mean = dt, .drag = drag});
    state.time += dt;
  }
  [[nodiscard]] Vec3 rate() const { return Vec3(state.rotations[0].rate); }
  [[nodiscard]] Eigen::Quaterniond turn() const {
    return Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(state.rotations[0].turn));
  }
  [[nodiscard]] const model::RotationAccount& account() const { return state.rotation_accounts[0]; }
};

}  // namespace

TEST_CASE("a free node keeps its rate, and turns by Cayley's rotation in each step") {
  Node node(2);
  const Vec3 axis = Vec3(1, -2, 2) / 3;
  constexpr double angle = 0.3;  // of each step
  Eigen::Map<Vec3>(node.state.rotations[0].rate) = 2 * std::tan(angle / 2) / 0.1 * axis;
  for (int n = 0; n < 7; ++n) node.step(0.1);
  const Eigen::Quaterniond exact(Eigen::AngleAxisd(7 * angle, axis));
  CHECK(node.turn().angularDistance(exact) < 1e-14);
  CHECK(node.turn().norm() == Approx(1).epsilon(1e-15));
  CHECK((node.rate() - 2 * std::tan(angle / 2) / 0.1 * axis).norm() == 0);
}

TEST_CASE("the work of moments is the energy of rotation") {
  Node node(2);
  node.scratch.moment[0] = Quad{1, 2, 3, 0};
  node.scratch.moment_load[0] = Quad{0, 0, 4, 0};
  for (int n = 0; n < 3; ++n) node.step(0.5);
  CHECK((node.rate() - 1.5 / 2 * Vec3(1, 2, 7)).norm() < 1e-15);
  const double energy = 0.5 * 2 * node.rate().squaredNorm();
  CHECK(node.account().element_work + node.account().load_work == Approx(energy).epsilon(1e-14));
  CHECK(node.account().load_work == Approx(4 * 0.5 * 1.5 * node.rate()[2]).epsilon(1e-14));
}

TEST_CASE("accounts at t_n leave out half of the last moments' work, and energy is conserved") {
  Node node(2);
  node.scratch.moment[0] = Quad{1, 2, 3, 0};
  node.scratch.moment_load[0] = Quad{0, 0, 4, 0};
  for (int n = 0; n < 3; ++n) node.step(0.5);
  const time::RotationEnergies now = time::rotation_energies(node.state, node.scratch, {.dt = 0.5, .dt_mean = 0.5}, 0);
  CHECK(now.kinetic == Approx(now.element_work + now.load_work).epsilon(1e-14));
  Node damped(2);
  damped.model.loads.damping.alpha = 1;
  damped.scratch.moment[0] = Quad{1, 2, 3, 0};
  for (int n = 0; n < 3; ++n) damped.step(0.5, 0.1);
  const time::RotationEnergies then =
      time::rotation_energies(damped.state, damped.scratch, {.dt = 0.5, .dt_mean = 0.5, .drag = 0.1}, 0);
  CHECK(then.damping_work < 0);
  CHECK(then.kinetic == Approx(then.element_work + then.damping_work).epsilon(1e-14));
}

TEST_CASE("a held direction takes the moment along it") {
  Node node(2);
  node.hold(Vec3(1, 1, 0).asDiagonal());
  node.scratch.moment[0] = Quad{1, 2, 3, 0};
  for (int n = 0; n < 4; ++n) node.step(0.25);
  CHECK((node.rate() - Vec3(0.5, 1, 0)).norm() < 1e-15);
  CHECK(node.account().reaction_impulse[2] == Approx(-3).epsilon(1e-15));
  CHECK(node.account().reaction_impulse[0] == 0);
  CHECK(node.account().reaction_work == 0);
}

TEST_CASE("a driven rotation follows its curve, whatever the step") {
  for (const int steps : {2, 20}) {
    Node node(2);
    const model::Curve curve{{{0.0, 0.0}}, {{1.0, 1.5}}};
    node.model.supports.drives.push_back({curve, 1, model::Drive::Gives::displacement});
    node.hold(Mat3::Zero(), 0);
    for (int n = 0; n < steps; ++n) node.step(1.0 / steps);
    const Eigen::Quaterniond exact(Eigen::AngleAxisd(1.5, Vec3::UnitZ()));
    CHECK(node.turn().angularDistance(exact) < 1e-14);
    CHECK(node.account().reaction_work == Approx(0.5 * 2 * node.rate().squaredNorm()).epsilon(1e-13));
  }
}
