// SPDX-License-Identifier: Apache-2.0
// Elements much wider than thick: what is a thickness away is far, however wide they are.
#include <catch2/catch.hpp>
#include <cmath>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

/// Two bars end to end, of elements 1 x 1 and a twentieth thick.
GlobalIndex pairs_of_flat_bars(const std::string& between) {
  constexpr int count = 40;
  mesh::Mesh mesh = mesh::box("left", {0.05 * count, 1, 1}, {count, 1, 1});
  mesh::Mesh right = mesh::box("right", {0.05 * count, 1, 1}, {count, 1, 1});
  mesh::place(right, 1, {0, 0, 1}, 0, {0.05 * count, 0, 0});
  mesh::append(mesh, std::move(right));
  Simulation bars(std::move(mesh),
                  "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
                  "parts: {left: {material: m}, right: {material: m}}\n"
                  "contact: [{between: " +
                      between + "}]\n");
  bars.step();
  return contact::collect(*bars.contact).pairs;
}

struct Crush {
  std::vector<Vec3> positions;
  GlobalIndex searches = 0, most_active = 0;
  double penetration = 0, taken = 0, kinetic_at_start = 0;
};

constexpr double thickness = 1.0 / 8;  // of an element

/// A rubber ring of elements twelve times as wide as thick, its upper and lower halves thrown at each other.
Crush crush_ring(const contact::Rebuild& rebuild) {
  Simulation ring(mesh::tube("ring", 9.5, 10.5, 0.5, {8, 40, 1}),
                  "materials: {rubber: {model: neo_hookean, density: 1.0e-3, young: 10, poisson: 0.3}}\n"
                  "parts: {ring: {material: rubber, element: hex8_full}}\n"
                  "symmetry: [{point: [0, 0, 0], normal: [0, 0, 1]}, {point: [0, 0, 0.5], normal: [0, 0, -1]}]\n"
                  "contact: [{between: all}]\n");
  ring.rebuild_lists(rebuild);
  for (LocalIndex node = 0; node < ring.nodes(); ++node)
    ring.state.nodes[static_cast<std::size_t>(node)].v[1] = -3 * ring.position(node).y();
  Crush crush;
  for (int step = 0; step < 2500; ++step) {
    ring.step();
    if (step == 0) crush.kinetic_at_start = ring.ledger().kinetic;
    crush.most_active = std::max(crush.most_active, contact::collect(*ring.contact).active);
  }
  for (LocalIndex node = 0; node < ring.nodes(); ++node) crush.positions.push_back(ring.position(node));
  crush.searches = ring.contact->ledger.statistics.searches;
  crush.penetration = contact::collect(*ring.contact).penetration;
  crush.taken = ring.ledger().contact_totals.contact_work;
  return crush;
}

}  // namespace

TEST_CASE("a body of flat elements is no candidate for contact with itself where it is straight", "[law]") {
  const GlobalIndex between_them = pairs_of_flat_bars("[left, right]");
  CHECK(between_them >= 4);  // the corners of one end with the face of the other
  CHECK(pairs_of_flat_bars("all") == between_them);
}

TEST_CASE("a body of flat elements that folds is held off itself, and lists that last lose nothing", "[law]") {
  const Crush crush = crush_ring({});
  CAPTURE(crush.searches, crush.most_active, crush.kinetic_at_start, crush.taken);
  CHECK(crush.most_active > 0);
  CHECK(crush.penetration <= 1e-2 * thickness);
  CHECK(crush.taken >= -1e-3 * crush.kinetic_at_start);
  const Crush always = crush_ring({.when = contact::Rebuild::When::every});
  CHECK(always.searches >= 2500);
  CHECK(crush.searches < always.searches / 3);
  CHECK((crush.positions == always.positions));
}
