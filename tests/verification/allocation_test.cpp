// SPDX-License-Identifier: Apache-2.0
// A time step allocates nothing, with all kinds of loads, walls and contact, but for steps that rebuild contact lists.
#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/allocations.hpp"
#include "support/simulation.hpp"

using namespace brunt;

namespace {

/// Steps that rebuild no list allocate nothing; many of these steps have contact to solve.
void check_quiet_steps(test::Simulation& run, int steps) {
  int quiet_steps = 0, solved_steps = 0;
  for (int i = 0; i < steps; ++i) {
    const contact::ContactStatistics before = run.contact->ledger.statistics;
    const long start = test::allocations;
    run.step();
    const long made = test::allocations - start;
    const contact::ContactStatistics& after = run.contact->ledger.statistics;
    if (i < 2 || after.searches != before.searches) continue;
    CHECK(made == 0);
    ++quiet_steps;
    solved_steps += after.solved_steps > before.solved_steps ? 1 : 0;
  }
  CHECK(quiet_steps >= 30);
  CHECK(solved_steps >= 10);
}

}  // namespace

TEST_CASE("a step with loads, damping, given motion, pressure and every kind of hexahedron allocates nothing",
          "[law]") {
  mesh::Mesh mesh;
  const char* kinds[] = {"hex8", "hex8_full", "hex8_bbar"};
  std::string parts = "parts:\n";
  for (int k = 0; k < 3; ++k) {
    mesh::Mesh box = mesh::box(kinds[k], {1, 1, 1}, {3, 3, 3});
    mesh::place(box, 1, {0, 0, 1}, 0, {2.0 * k, 0, 0});
    mesh::append(mesh, std::move(box));
    parts += std::string("  ") + kinds[k] + ": {material: m, element: " + kinds[k] + "}\n";
  }
  test::Simulation run(std::move(mesh),
                       "materials: {m: {model: j2, density: 8000, young: 2.0e11, poisson: 0.3, yield: 4.0e8}}\n" +
                           parts +
                           "curves: {ramp: [[0, 0], [1, 1]]}\n"
                           "gravity: {vector: [0, 0, -9.81], curve: ramp}\n"
                           "damping: {alpha: 10}\n"
                           "pressure: [{set: hex8_xmin, value: 1.0e6, curve: ramp}]\n"
                           "fixed: [{set: hex8_zmin, dofs: [x, y, z]}]\n"
                           "prescribed: [{set: hex8_full_xmax, dof: x, velocity: ramp}]\n");
  run.step();
  const long start = test::allocations;
  run.steps(20);
  CHECK(test::allocations - start == 0);
  CHECK(start > 0);
}

TEST_CASE("a step with contact and a wall allocates nothing between rebuilds of its lists", "[law]") {
  mesh::Mesh mesh = mesh::box("below", {4, 4, 1}, {4, 4, 1}), above = mesh::box("above", {3, 3, 1}, {5, 5, 2});
  mesh::place(above, 1, {0, 0, 1}, 0, {0.4, 0.3, 1.001});
  mesh::append(mesh, std::move(above));
  test::Simulation run(std::move(mesh),
                       "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\n"
                       "parts: {below: {material: m}, above: {material: m}}\n"
                       "initial: [{part: above, velocity: [0, 0, -50]}]\n"
                       "rigid_walls: [{point: [0, 0, -0.0001], normal: [0, 0, 1]}]\n"
                       "contact: [{between: all}]\n");
  check_quiet_steps(run, 60);
}

TEST_CASE(
    "a step with rigid bodies allocates nothing: free, driven, tied, joined, with a soft part on them, in contact",
    "[law]") {
  mesh::Mesh mesh = mesh::box("plate", {4, 4, 1}, {4, 4, 1});
  const auto add = [&](const char* part, const Vec3& size, const std::array<int, 3>& elements, const Vec3& at) {
    mesh::Mesh box = mesh::box(part, size, elements);
    mesh::place(box, 1, {0, 0, 1}, 0, at);
    mesh::append(mesh, std::move(box));
  };
  add("block", {2, 2, 1}, {4, 4, 2}, {0.5, 0.5, 1});
  add("tool", {1, 1, 1}, {3, 3, 3}, {0.8, 0.9, 2.001});
  add("cap", {1, 1, 0.5}, {1, 1, 1}, {0.9, 0.9, 3});
  add("driven", {1, 1, 1}, {2, 2, 2}, {2.501, 1, 1.5});
  test::Simulation run(std::move(mesh),
                       "materials:\n"
                       "  hard: {model: rigid, density: 8000}\n"
                       "  soft: {model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.3}\n"
                       "parts: {plate: {material: hard}, block: {material: soft}, tool: {material: hard},\n"
                       "  cap: {material: hard, rigid: {joins: tool}}, driven: {material: hard}}\n"
                       "initial: [{part: tool, velocity: [0, 0, -5], rotation: {axis: [0, 0, 1], rate: 2}}]\n"
                       "gravity: {vector: [0, 0, -9.81]}\n"
                       "damping: {alpha: 1}\n"
                       "fixed: [{part: driven, dofs: [y, z, rx]}]\n"
                       "prescribed: [{part: driven, dof: x, velocity: -1}, {part: driven, dof: rz, velocity: 0.5}]\n"
                       "pressure: [{set: tool_zmax, value: 1.0e3}]\n"
                       "rigid_walls: [{point: [0, 0, -0.0001], normal: [0, 0, 1], friction: 0.2}]\n"
                       "contact: [{between: all, friction: 0.2}, {between: [plate, block], tied: true}]\n");
  check_quiet_steps(run, 60);
}
