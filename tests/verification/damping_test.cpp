// SPDX-License-Identifier: Apache-2.0
// Mass damping as part of the mobility: order of decay, signs, what a resting contact carries, what the ledger books.
#include <catch2/catch.hpp>
#include <cmath>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

const std::string soft = "materials: {m: {model: elastic, density: 8000, young: 2.0e7, poisson: 0.3}}\n";

Simulation thrown(const std::string& damping, const std::string& run = "") {
  return Simulation(
      mesh::box("block", {1, 1, 1}, {2, 1, 1}),
      soft + "parts: {block: {material: m}}\n" + damping + "initial: [{part: block, velocity: [3, -1, 0.5]}]\n" + run);
}

/// Two bodies or one, the lower face of which is held as `below` says; gravity in -z.
Simulation pressed(const std::string& below, const std::string& method, const Vec3& size, double young) {
  mesh::Mesh mesh = mesh::box("block", size, {2, 2, 2});
  if (below != "wall") {
    mesh::Mesh under = mesh::box("under", {1.3 * size[0], 1.2 * size[1], size[2]}, {3, 2, 1});
    mesh::place(under, 1, Vec3::UnitZ(), 0, {-0.11 * size[0], -0.07 * size[1], -size[2]});
    mesh::append(mesh, std::move(under), "");
  }
  std::string scene = "materials: {m: {model: elastic, density: 7800, young: " + std::to_string(young) +
                      ", poisson: 0.3}}\ngravity: {vector: [0, 0, -9.81]}\ndamping: {alpha: 1}\n";
  const std::string wall = "rigid_walls: [{name: floor, point: [0, 0, Z], normal: [0, 0, 1]}]\n";
  const auto at = [&](double z) { return std::string(wall).replace(wall.find('Z'), 1, std::to_string(z)); };
  if (below == "wall") return Simulation(std::move(mesh), scene + "parts: {block: {material: m}}\n" + at(0));
  scene +=
      "parts: {block: {material: m}, under: {material: m}}\ncontact: [{between: all, tolerance: 1.0e-10, method: " +
      method + "}]\n";
  scene += below == "fixed" ? "fixed: [{set: under_zmin, dofs: [x, y, z]}]\n" : at(-size[2]);
  return Simulation(std::move(mesh), scene);
}

/// One step for all: springs of contact that depend on the step stay as they are, and 4.5e5 dt < 2.
constexpr double dt = 3.9e-6;

/// Steps until nothing moves: damped at about the rate of the slowest vibration.
void settle(Simulation& s, double height, double young) {
  s.model.loads.damping.alpha = 2 * std::sqrt(young / 7800) / height;
  s.steps(4000, dt);
}

struct Carried {
  double below = 0;  ///< by what holds all of it, over all weight
  double between = 0;
};

/// Mean force over some steps under this damping, over the weights that it carries.
Carried carried(Simulation& s, double alpha, bool off) {
  s.model.loads.damping.alpha = off ? 1 : alpha;
  s.model.loads.damping.to = off ? 0 : 1e300;
  s.steps(2, dt);
  const time::Ledger before = s.ledger();
  std::vector<Vec3> given(static_cast<std::size_t>(s.nodes()), Vec3::Zero());
  double time = 0, weight = 0, upper = 0, push = 0;
  for (int i = 0; i < 20; ++i) {
    s.step(dt);
    time += dt;
    contact::add_impulses(*s.contact, given);
  }
  const time::Ledger after = s.ledger();
  for (LocalIndex i = 0; i < s.nodes(); ++i) weight += 9.81 * s.mass(i);
  const model::ElementBlock& block = s.model.blocks[0];
  std::vector<char> seen(given.size(), 0);
  for (LocalIndex e = 0; e < block.count; ++e)
    for (int c = 0; c < 8; ++c) {
      const auto node = static_cast<std::size_t>(block.corner_node(e, c));
      if (seen[node] != 0) continue;
      seen[node] = 1;
      upper += 9.81 * s.mass(static_cast<LocalIndex>(node));
      push += given[node][2];
    }
  // of loads, reactions and walls together: what is not the weight came from below
  const Vec3 held = after.impulse_given - before.impulse_given;
  return {1 + held[2] / (weight * time), push / (upper * time)};
}

}  // namespace

TEST_CASE("damping lets a velocity decay by (1 - a) / (1 + a) a step, of second order, and books the loss",
          "[oracle]") {
  const double alpha = 50, end = 0.02;
  double error[3];
  for (int i = 0; i < 3; ++i) {
    const int steps = 100 << i;
    const double dt = end / steps, a = 0.5 * alpha * dt;
    Simulation block = thrown("damping: {alpha: 50}\n");
    block.step(dt);
    const double start = block.ledger().total();
    block.steps(steps, dt);
    const time::Ledger ledger = block.ledger();
    CHECK(start == Approx(0.5 * 8000 * 10.25).epsilon(1e-2));
    CHECK(ledger.total() == Approx(start).epsilon(1e-12));
    const double exact = (1 - 0.5 * a) / (1 + 0.5 * a) * std::pow((1 - a) / (1 + a), steps);
    for (LocalIndex n = 0; n < block.nodes(); ++n) CHECK((block.velocity(n) - exact * Vec3(3, -1, 0.5)).norm() < 1e-12);
    error[i] = std::abs(exact - std::exp(-alpha * (end + dt / 2)));
  }
  CHECK(std::log2(error[0] / error[1]) == Approx(2).margin(0.1));
  CHECK(std::log2(error[1] / error[2]) == Approx(2).margin(0.1));
}

TEST_CASE("alpha dt < 2 bounds the step before and while damping acts, and no velocity changes its sign", "[law]") {
  for (const double alpha : {10.0, 1e4, 4.5e5, 1e8}) {
    CAPTURE(alpha);
    const double from = 5e-3, to = 3e-2;
    Simulation block = thrown("damping: {alpha: " + std::to_string(alpha) + ", from: 5.0e-3, to: 3.0e-2}\n");
    double free_step = 0, speed = 3, lost = 0;
    int acted = 0;
    while (block.state.time < 1.3 * to && acted < 300) {
      const double t = block.state.time;
      block.step();
      const time::Ledger ledger = block.ledger();
      if (t < from) free_step = std::max(free_step, block.report.dt);
      CHECK(block.report.stable_dt >= block.report.dt);
      const bool acts = t >= from && t < to;
      acted += acts ? 1 : 0;
      CHECK(block.report.alpha == (acts ? alpha : 0));
      CHECK(block.report.drag() < 1);
      const double now = block.velocity(0)[0];
      CHECK(now >= 0);
      CHECK(now <= speed * (1 + 1e-9));
      CHECK(ledger.damping >= lost);
      speed = now;
      lost = ledger.damping;
    }
    CHECK(acted > 2);
    CHECK(free_step > 5e-5);
    CHECK(lost == Approx(0.5 * 8000 * 10.25 * (1 - std::pow(speed / 3, 2))).epsilon(1e-6));
  }
}

TEST_CASE("a resting contact carries the weight whatever the damping", "[oracle]") {
  struct Case {
    std::string below, method;
    Vec3 size;
    double young;
  };
  const Vec3 cube(0.1, 0.1, 0.1), flat(0.17, 0.12, 0.08);
  for (const Case& c :
       {Case{"wall", "rate", cube, 2e11}, Case{"wall", "rate", flat, 4e10}, Case{"fixed", "rate", cube, 2e11},
        Case{"fixed", "rate", flat, 4e10}, Case{"other", "rate", cube, 2e11}, Case{"other", "row_sum", flat, 2e11},
        Case{"other", "penalty", cube, 2e11}, Case{"other", "gap_penalty", cube, 2e11}}) {
    CAPTURE(c.below, c.method, c.size[2]);
    Simulation s = pressed(c.below, c.method, c.size, c.young);
    settle(s, c.size[2] * (c.below == "wall" ? 1 : 2), c.young);
    for (const double alpha : {0.0, 100.0, 1e4, 4.5e5, 0.0}) {
      CAPTURE(alpha);
      const Carried now = carried(s, alpha, alpha == 0);
      CHECK(now.below == Approx(1).epsilon(1e-10));
      CHECK(now.between == Approx(1).epsilon(1e-10));
    }
  }
}

TEST_CASE("energy and momentum are kept through damped impacts, begun and ended in them", "[law]") {
  for (const std::string method : {"rate", "row_sum", "gap_penalty"})
    for (const double alpha : {100.0, 1e4, 1e6})
      for (const std::string passes : {"one", "two"}) {
        CAPTURE(method, alpha, passes);
        if (method == "gap_penalty" && alpha > 1e5) continue;  // its springs stiffen as the step falls
        const double to = alpha > 1e5 ? 0.0302 : 0.05;         // some hundred steps of it
        mesh::Mesh mesh = mesh::box("a", {1, 1, 1}, {2, 2, 2});
        mesh::Mesh other = mesh::box("b", {1, 1, 1}, {3, 3, 3});
        mesh::place(other, 1, Vec3(1, 2, 3), 20, {0.2, 0.1, 1.3});
        mesh::append(mesh, std::move(other), "");
        Simulation s(
            std::move(mesh),
            soft + "parts: {a: {material: m}, b: {material: m}}\nfixed: [{set: a_zmin, dofs: [x, y, z]}]\n" +
                "initial: [{part: b, velocity: [1, 0, -12]}]\ncontact: [{between: all, friction: 0.3, method: " +
                method + ", passes: " + passes + "}]\ndamping: {alpha: " + std::to_string(alpha) +
                ", from: 0.03, to: " + std::to_string(to) + "}\ngravity: {vector: [0, 1, -9.81]}\n");
        s.step();
        const time::Ledger start = s.ledger();
        double lost = 0, largest = start.kinetic;
        for (int i = 0; i < 800; ++i) {
          s.step();
          if (i % 20 != 0) continue;
          const time::Ledger now = s.ledger();
          largest = std::max({largest, now.kinetic, now.internal});
          CHECK(std::abs(now.total() - start.total()) < 1e-11 * largest);
          CHECK((now.momentum - now.impulse_given - start.momentum + start.impulse_given).norm() <
                1e-10 * start.momentum_scale);
          CHECK(now.damping >= lost - 1e-12 * start.kinetic);
          lost = now.damping;
        }
        CHECK(s.ledger().contact_totals.push > 0);
        CHECK(lost > 0);
        CHECK(s.state.time > to);
      }
}
