// SPDX-License-Identifier: Apache-2.0
// Central differences on nodes whose forces are given: exact values of the scheme itself, no elements.
#include "time/motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace brunt;
using model::Drive;

namespace {

/// Free nodes on a line, at rest.
struct Nodes {
  model::Model model;
  model::State state;
  model::Scratch scratch;

  explicit Nodes(const std::vector<double>& masses) {
    for (std::size_t i = 0; i < masses.size(); ++i) {
      model.mesh.node_gid.push_back(static_cast<GlobalIndex>(i));
      model.reference.push_back(Quad{static_cast<double>(i), 0.5, -0.25, 0});
      model::NodeLine& node = state.nodes.emplace_back();
      node = {};
      for (std::size_t c = 0; c < 3; ++c) node.x[c] = model.reference[i][c];
      node.mass = masses[i];
      state.displacement.push_back(Quad{});
      scratch.force.push_back(Quad{});
    }
    scratch.before.assign(masses.size(), Vec3::Zero());
  }
  void step(double dt, double dt_mean) { time::predict(model, state, scratch, {.dt = dt, .dt_mean = dt_mean}); }
};

/// Displacement at t = 1 of a unit mass on a spring of frequency w that starts at 1 without velocity.
double oscillator(double w, int steps) {
  Nodes point({1.0});
  const double dt = 1.0 / steps;
  point.state.displacement[0][0] = 1;
  for (int n = 0; n < steps; ++n) {
    point.scratch.force[0] = Quad{-w * w * point.state.displacement[0][0], 0, 0, 0};
    point.step(dt, n == 0 ? 0.5 * dt : dt);  // the first half step starts the staggered velocity
  }
  return point.state.displacement[0][0];
}

}  // namespace

TEST_CASE("central differences: a spring moves as the difference equation's own solution says, of order 2") {
  constexpr double w = 3;
  std::vector<double> errors;
  for (const int steps : {10, 20, 40, 80}) {
    // u_{n+1} - 2 u_n + u_{n-1} = -(w dt)^2 u_n has the solution cos(n W) with sin(W / 2) = w dt / 2
    const double discrete = std::cos(steps * 2 * std::asin(0.5 * w / steps));
    CHECK(oscillator(w, steps) == Approx(discrete).epsilon(1e-12));
    errors.push_back(std::abs(oscillator(w, steps) - std::cos(w)));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) CHECK(std::log2(errors[i - 1] / errors[i]) == Approx(2).margin(0.05));
}

TEST_CASE("central differences: stable up to w dt = 2, not beyond") {
  const auto largest = [](double w_dt) {
    Nodes point({1.0});
    point.state.displacement[0][0] = 1;
    double most = 0;
    for (int n = 0; n < 2000; ++n) {
      point.scratch.force[0] = Quad{-w_dt * w_dt * point.state.displacement[0][0], 0, 0, 0};
      point.step(1, n == 0 ? 0.5 : 1.0);
      most = std::max(most, std::abs(point.state.displacement[0][0]));
    }
    return most;
  };
  CHECK(largest(1.99) <= 1 + 1e-9);
  CHECK(largest(2.01) > 1e6);
}

TEST_CASE("central differences: without force velocities keep their bits, and positions follow X + u") {
  Nodes nodes({1.0, 2.0, 1e6});
  for (std::size_t i = 0; i < 3; ++i) {
    nodes.state.nodes[i].v[0] = 0.1 * static_cast<double>(i + 1);
    nodes.state.nodes[i].v[1] = -1.0 / 3;
    nodes.state.nodes[i].v[2] = 7e-5;
  }
  for (int n = 0; n < 50; ++n) nodes.step(0.01 * (1 + n % 3), 0.013);
  for (std::size_t i = 0; i < 3; ++i) {
    const model::NodeLine& node = nodes.state.nodes[i];
    CHECK(node.v[0] == 0.1 * static_cast<double>(i + 1));
    CHECK(node.v[1] == -1.0 / 3);
    CHECK(node.v[2] == 7e-5);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(node.x[c] == nodes.model.reference[i][c] + nodes.state.displacement[i][c]);
    CHECK(nodes.state.displacement[i][3] == 0);  // no force, no work
  }
}

TEST_CASE("central differences: forces that cancel keep the momentum, each node takes dt_mean f / m") {
  Nodes nodes({1.0, 3.0, 0.25});
  nodes.scratch.force[0] = Quad{1, -2, 0.5, 0};
  nodes.scratch.force[1] = Quad{-0.25, 2.5, 0, 0};
  nodes.scratch.force[2] = Quad{-0.75, -0.5, -0.5, 0};
  nodes.step(0.125, 0.0625);  // powers of two: no rounding
  Vec3 momentum = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const model::NodeLine& node = nodes.state.nodes[i];
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(node.v[c] == Approx(0.0625 * nodes.scratch.force[i][c] / node.mass).epsilon(1e-15));
      CHECK(nodes.state.displacement[i][c] == 0.125 * node.v[c]);
      momentum[static_cast<Eigen::Index>(c)] += node.mass * node.v[c];
    }
  }
  CHECK(momentum.norm() <= 1e-16);
}

TEST_CASE("central differences: work of a force is its impulse times the mean of the velocities around it") {
  Nodes point({2.0});
  point.state.nodes[0].v[0] = 3;
  point.scratch.force[0] = Quad{8, 0, 0, 0};
  point.step(0.25, 0.5);  // 3 -> 5 over dt_mean 0.5: impulse 4, mean velocity 4
  CHECK(point.state.nodes[0].v[0] == 5);
  CHECK(point.state.displacement[0][3] == 16);  // = 2 (25 - 9) / 2
}

TEST_CASE("central differences: damping on the mean velocity lets it decay by (1 - a) / (1 + a), and books the loss") {
  Nodes point({2.0});
  point.model.loads.damping.alpha = 1;
  point.scratch.load.assign(1, Quad{});
  point.state.load_work.assign(1, 0);
  point.state.damping_work.assign(1, 0);
  point.state.load_impulse.assign(3, 0);
  point.state.nodes[0].v[0] = 3;
  constexpr double a = 0.25;
  time::predict(point.model, point.state, point.scratch, {.dt = 0.5, .dt_mean = 0.5, .drag = a});
  const double after = 3 * (1 - a) / (1 + a);
  CHECK(point.state.nodes[0].v[0] == Approx(after).epsilon(1e-15));
  CHECK(point.state.damping_work[0] == Approx(0.5 * 2 * (after * after - 9)).epsilon(1e-14));
  CHECK(point.state.load_impulse[0] == Approx(2 * (after - 3)).epsilon(1e-14));
}

TEST_CASE("prescribed motion: a displacement is met at the end of every step, whatever the steps") {
  const Drive drive{{{0, 0}, {0.3, 0.7}, {0.5, -0.2}, {1, 0.4}}, 2, Drive::Gives::displacement};
  double u = 0, t = 0;
  for (int n = 0; t < 0.95; ++n) {
    const double dt = 0.01 * (1 + n % 5);
    u += dt * time::driven_component(drive, 99, t, dt, 123);
    t += dt;
    const double exact = t < 0.3 ? 1.4 * t / 0.3 : t < 0.5 ? 1.4 - 1.8 * (t - 0.3) / 0.2 : -0.4 + 1.2 * (t - 0.5) / 0.5;
    CHECK(u == Approx(exact).margin(1e-14));
  }
}

TEST_CASE("prescribed motion: a velocity is that of the half step, an acceleration adds its integral since the last") {
  const Drive velocity{{{0, 0}, {1, 4}}, 0.5, Drive::Gives::velocity};
  CHECK(time::driven_component(velocity, 99, 0.25, 0.5, 7) == Approx(1).epsilon(1e-15));  // 2 (0.25 + 0.25)
  const Drive acceleration{{{0, 1}, {1, 3}}, 10, Drive::Gives::acceleration};
  // from 0.5 + 0.1 - 0.3 to 0.6: the integral of 1 + 2 t is t + t^2
  CHECK(time::driven_component(acceleration, 2, 0.5, 0.2, 0.3) ==
        Approx(2 + 10 * (0.6 + 0.36 - 0.3 - 0.09)).epsilon(1e-14));
}
