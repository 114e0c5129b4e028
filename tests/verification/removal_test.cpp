// SPDX-License-Identifier: Apache-2.0
// Elements that leave the model: what stays goes on as if they had never been, to the last bit where nothing joins
// them; energy, momentum and mass are accounted for; nothing of a removed element is computed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "model/alive.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

const std::string steel =
    "materials: {m: {model: j2, density: 8000, young: 2.0e11, poisson: 0.3, yield: 4.0e8, hardening: 1.0e9}}\n";

/// A bar of 2 x 2 x 8 elements along z that flies, spins and is shaken, so that it flows and its hourglass modes move.
Simulation shaken_bar(const std::string& element, const std::string& more) {
  Simulation bar(mesh::box("bar", {1, 1, 4}, {2, 2, 8}),
                 steel + "parts: {bar: {material: m, element: " + element +
                     "}}\n"
                     "sets: {upper: {part: bar, box: [[0, 0, 2], [1, 1, 4]]}, all: {part: bar}}\n" +
                     more);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> noise(-150, 150);
  for (LocalIndex i = 0; i < bar.nodes(); ++i)
    Eigen::Map<Vec3>(bar.state.nodes[static_cast<std::size_t>(i)].v) =
        Vec3(30, 0, 10) + Vec3(noise(engine), noise(engine), noise(engine));
  return bar;
}

/// Of a bar that loses elements at this time: total energy and momentum as they were.
void check_balance(Simulation& bar, int steps) {
  bar.step();
  const time::Ledger start = bar.ledger();
  for (int i = 0; i < steps; ++i) {
    bar.step();
    const time::Ledger now = bar.ledger();
    CHECK(now.total() == Approx(start.total()).epsilon(1e-11));
    CHECK((now.momentum - start.momentum).norm() < 1e-12 * start.momentum_scale);
    CHECK(now.mass == start.mass);
  }
}

std::vector<Vec3> velocities(const Simulation& bar) {
  std::vector<Vec3> all;
  for (LocalIndex i = 0; i < bar.nodes(); ++i) all.push_back(bar.velocity(i));
  return all;
}

GlobalIndex dead(const Simulation& bar) {
  return std::ranges::count(bar.state.alive[0], 0.0);
}

}  // namespace

TEST_CASE("a free bar that loses its half in flight keeps its energy, momentum and mass", "[removal][law]") {
  for (const std::string element : {"hex8", "hex8_full", "hex8_bbar"}) {
    CAPTURE(element);
    Simulation bar = shaken_bar(element, "remove: [{set: upper, at: 1.5e-3}]\n");
    check_balance(bar, 120);
    CHECK(dead(bar) == 16);
    const time::Ledger ledger = bar.ledger();
    CHECK(ledger.eroded > 0.01 * ledger.internal);
    CHECK(ledger.internal > 0);
  }
}

TEST_CASE("what leaves is booked as eroded: with everything gone nothing is left but the motion of mass points",
          "[removal][law]") {
  for (const std::string element : {"hex8", "hex8_full", "hex8_bbar"}) {
    CAPTURE(element);
    Simulation bar = shaken_bar(element, "remove: [{set: upper, at: 1.5e-3}, {part: bar, at: 2.5e-3}]\n");
    time::Ledger before;
    while (dead(bar) < 32) {
      if (bar.state.step > 0) before = bar.ledger();
      bar.step();
    }
    const time::Ledger at = bar.ledger();
    const double scale = at.eroded;
    CHECK(scale > 0);
    CHECK(std::abs(at.internal) < 1e-11 * scale);
    CHECK(at.hourglass == 0);
    CHECK(at.bulk == 0);
    CHECK(at.total() == Approx(before.total()).epsilon(1e-11));
    const double step_before = before.internal + before.hourglass + before.bulk + before.eroded;
    CHECK(at.eroded == Approx(step_before).epsilon(0.2));  // a step lies between the two
    bar.step();  // the last forces have acted with the second half of their impulses
    const time::Ledger after = bar.ledger();
    CHECK(after.total() == Approx(before.total()).epsilon(1e-11));
    const double dt = bar.state.dt;
    const std::vector<Vec3> v = velocities(bar);
    bar.steps(50);
    CHECK(velocities(bar) == v);
    CHECK(bar.state.dt == dt);  // no element says anything of the step
    CHECK(bar.ledger().eroded == after.eroded);
    CHECK(bar.ledger().kinetic == after.kinetic);
  }
}

TEST_CASE("elements removed at t = 0 act in the first step alone, by viscosity", "[removal][law]") {
  Simulation bar = shaken_bar("hex8", "remove: [{part: bar, at: 0}]\n");
  bar.steps(2);
  const std::vector<Vec3> v = velocities(bar);
  const time::Ledger first = bar.ledger();
  CHECK(dead(bar) == 32);
  CHECK(std::abs(first.internal) < 1e-12 * first.eroded);
  bar.steps(20);
  CHECK(velocities(bar) == v);
  CHECK(bar.ledger().eroded == first.eroded);
}

namespace {

/// Two boxes of one part, apart from each other: elements of both share batches.
Simulation two_boxes(const std::string& element, const std::string& more) {
  mesh::Mesh whole = mesh::box("a", {1, 1, 1}, {3, 3, 3});
  mesh::Mesh other = mesh::box("a", {1, 1, 1}, {3, 1, 1});
  mesh::place(other, 1, {0, 0, 1}, 0, {5, 0, 0});
  const auto shift = static_cast<LocalIndex>(whole.coordinates.size());
  whole.coordinates.insert(whole.coordinates.end(), other.coordinates.begin(), other.coordinates.end());
  for (const GlobalIndex id : other.node_id) whole.node_id.push_back(id + shift);
  for (const LocalIndex node : other.blocks[0].nodes) whole.blocks[0].nodes.push_back(node + shift);
  for (const GlobalIndex id : other.blocks[0].element_id) whole.blocks[0].element_id.push_back(id + 27);
  Simulation boxes(std::move(whole), steel + "parts: {a: {material: m, element: " + element + "}}\n" +
                                         "sets: {other: {box: [[5, 0, 0], [6, 1, 1]]}}\n" + more);
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> noise(-100, 100);
  for (LocalIndex i = 0; i < boxes.nodes(); ++i)
    Eigen::Map<Vec3>(boxes.state.nodes[static_cast<std::size_t>(boxes.node(i))].v) =
        Vec3(noise(engine), noise(engine), noise(engine));
  return boxes;
}

bool is_in_other(const Simulation& boxes, LocalIndex node) {
  return boxes.model.mesh.coordinates[static_cast<std::size_t>(node)].x() + boxes.model.mesh.origin.x() > 3;
}

}  // namespace

TEST_CASE("removed elements change no bit of others in their batch, whatever becomes of their nodes",
          "[removal][law]") {
  for (const std::string element : {"hex8", "hex8_full"}) {
    CAPTURE(element);
    Simulation kept = two_boxes(element, "");
    Simulation cut = two_boxes(element, "remove: [{set: other, at: 2.0e-4}]\n");
    constexpr double dt = 2e-5;
    kept.steps(30, dt);
    cut.steps(30, dt);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (LocalIndex i = 0; i < cut.nodes(); ++i)
      if (is_in_other(cut, i)) Eigen::Map<Vec3>(cut.state.nodes[static_cast<std::size_t>(i)].x).setConstant(nan);
    kept.steps(30, dt);
    cut.steps(30, dt);
    REQUIRE(std::ranges::count(cut.state.alive[0], 0.0) == 3);
    CHECK_FALSE(cut.report.stop);
    for (LocalIndex i = 0; i < cut.nodes(); ++i)
      if (!is_in_other(cut, i)) {
        CHECK(cut.displacement(i) == kept.displacement(i));
        CHECK(cut.velocity(i) == kept.velocity(i));
      }
    for (LocalIndex e = 0; e < 30; ++e)
      if (model::lives(cut.state, 0, e)) CHECK(cut.history(0, "stress", e, 0) == kept.history(0, "stress", e, 0));
  }
}

TEST_CASE("a pressure ends with the elements of its faces", "[removal][law]") {
  Simulation block(mesh::box("b", {1, 1, 2}, {2, 2, 4}), steel +
                                                             "parts: {b: {material: m}}\n"
                                                             "sets: {top: {part: b, box: [[0, 0, 1.5], [1, 1, 2]]}}\n"
                                                             "pressure: [{set: b_zmax, value: 1.0e6}]\n"
                                                             "remove: [{set: top, at: 2.0e-4}]\n");
  while (dead(block) == 0) block.step();
  CHECK(dead(block) == 4);
  block.step();
  const Vec3 given = block.ledger().impulse_given;
  CHECK(given.z() < 0);
  block.steps(50);
  CHECK((block.ledger().impulse_given - given).norm() == 0);
  CHECK(std::abs(block.ledger().total()) < 1e-12 * block.ledger().kinetic);  // it began at rest
}

TEST_CASE("the step follows the elements that are left", "[removal][law]") {
  Simulation pair(
      [] {
        mesh::Mesh whole;
        mesh::append(whole, mesh::box("fine", {1, 1, 1}, {8, 8, 8}), "");
        mesh::Mesh coarse = mesh::box("coarse", {1, 1, 1}, {2, 2, 2});
        mesh::place(coarse, 1, {0, 0, 1}, 0, {3, 0, 0});
        mesh::append(whole, std::move(coarse), "");
        return whole;
      }(),
      steel + "parts: {fine: {material: m}, coarse: {material: m}}\nremove: [{part: fine, at: 1.0e-4}]\n");
  pair.step();
  const double fine = pair.state.dt;
  pair.steps(500);
  CHECK(pair.state.dt == Approx(4 * fine).epsilon(0.01));
}

TEST_CASE("dropped nodes take their energy, momentum and mass along, and no load finds them", "[removal][law]") {
  Simulation bar =
      shaken_bar("hex8", "gravity: {vector: [0, 0, -1000]}\nremove: [{set: upper, at: 1.0e-3, nodes: drop}]\n");
  bar.step();
  const time::Ledger start = bar.ledger();
  for (int i = 0; i < 100; ++i) {
    bar.step();
    const time::Ledger now = bar.ledger();
    CHECK(now.total() == Approx(start.total()).epsilon(1e-11));
    const Vec3 own = now.momentum - now.impulse_given, own_at_start = start.momentum - start.impulse_given;
    CHECK((own - own_at_start).norm() < 1e-12 * start.momentum_scale);
  }
  CHECK(std::ranges::count(bar.state.alive[0], -1.0) == 16);
  CHECK(bar.state.living.dropped.size() == 36);
  CHECK(bar.ledger().mass == Approx(start.mass * 18 / 32).epsilon(1e-12));  // and the shares of the nodes between
  CHECK(bar.ledger().eroded > 0);
}
