// SPDX-License-Identifier: Apache-2.0
// A plate tied along one end that swings down onto what it is tied to: the other nodes make contact, or nothing does. A
// lap joint that is held from bending.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "tests/support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr double thickness = 0.01;  // of the base, whose top is at z = 0 [m]

/// A plate that stands off its base by 6 degrees from x = 0 on: 4.2 mm at its other end, where ties reach 2.5 mm.
Simulation swinging_plate(const std::string& contact) {
  mesh::Mesh mesh = mesh::box("base", {0.04, 0.04, thickness}, {4, 4, 1});
  for (Vec3& x : mesh.coordinates) x.z() -= thickness;
  mesh::Mesh plate = mesh::box("plate", {0.04, 0.04, 0.004}, {8, 8, 1});
  const double angle = 6 * std::numbers::pi / 180;
  for (Vec3& x : plate.coordinates)
    x = Vec3(std::cos(angle) * x.x() - std::sin(angle) * x.z(), x.y(),
             std::sin(angle) * x.x() + std::cos(angle) * x.z());
  mesh::append(mesh, std::move(plate));
  return {std::move(mesh),
          "materials: {m: {model: elastic, density: 1000, young: 1.0e8, poisson: 0.3}}\n"
          "parts: {base: {material: m}, plate: {material: m}}\n"
          "initial: [{part: plate, velocity: [0, 0, -20]}]\n"
          "contact: [{between: [base, plate], tied: true}, " +
              contact + "]\n"};
}

struct Seen {
  std::size_t pushes = 0;  ///< most rows at once that are no ties and have an impulse
  double lowest = 0;       ///< node of the plate against the base's top, over the run [m]
};

Seen swing(Simulation& pair) {
  Seen seen;
  while (pair.state.time < 4e-4) {
    pair.step();
    std::size_t pushes = 0;
    for (std::size_t q = 0; q < pair.contact->step.rows.size(); ++q)
      if (!pair.contact->step.rows[q].holds && !pair.contact->step.impulses[q].isZero(0)) ++pushes;
    seen.pushes = std::max(seen.pushes, pushes);
    double top = 0;  // of the base's far edge, which gives way under the blow
    for (GlobalIndex input = 0; input < 50; ++input)
      if (const Vec3 x = pair.position(pair.node(input)); x.x() > 0.0399) top = std::max(top, x.z());
    for (GlobalIndex input = 50; input < 50 + 2 * 81; ++input)
      if (const Vec3 x = pair.position(pair.node(input)); x.x() > 0.03)
        seen.lowest = std::min(seen.lowest, x.z() - top);
  }
  return seen;
}

/// A lap joint of two strips that lie flush, tied, pulled apart at 1 m/s along x, with some parts held along z, the
/// normal of the tie: the work of the tie and of the pull, and how far the tied end of the lower strip has come.
struct Pulled {
  double tie = 0, pull = 0;  ///< [J]
  double end = 0;            ///< [m]
};

Pulled pull_lap_joint(const std::string& held) {
  mesh::Mesh mesh = mesh::box("lower", {0.04, 0.01, 0.002}, {20, 5, 2}),
             upper = mesh::box("upper", {0.04, 0.01, 0.002}, {16, 4, 2});
  mesh::place(upper, 1, {0, 0, 1}, 0, {0.025, 0, 0.002});
  mesh::append(mesh, std::move(upper));
  Simulation lap(std::move(mesh),
                 "materials: {steel: {model: elastic, density: 7800, young: 2.1e11, poisson: 0.3}}\n"
                 "parts: {lower: {material: steel}, upper: {material: steel}}\n"
                 "sets: {foot: {box: [[-1, -1, -1], [0.0001, 1, 1]]}, head: {box: [[0.0649, -1, -1], [1, 1, 1]]}}\n"
                 "fixed: [{set: foot, dofs: [x, y, z]}" +
                     held +
                     "]\ncurves: {pull: [[0, 1], [1, 1]]}\n"
                     "prescribed: [{set: head, dof: x, velocity: pull}]\n"
                     "contact: [{between: [lower, upper], tied: true}]\n");
  while (lap.state.time < 1e-4) lap.step();
  const time::Ledger energies = lap.ledger();
  Pulled pulled{std::abs(energies.contact) + std::abs(energies.friction), energies.external, 0};
  for (GlobalIndex input = 0; input < 21 * 6 * 3; ++input)
    pulled.end = std::max(pulled.end, lap.displacement(lap.node(input)).x());
  return pulled;
}

}  // namespace

// A node that is held along the normal of a tie counted as one that takes nothing of it: it was solved with too small
// an H where one side was held, which blew up within 60 steps, and left out where both were.
TEST_CASE("tied strips hold each other across the normal whoever is held along it", "[law]") {
  const Pulled loose = pull_lap_joint("");
  CHECK(loose.end > 4e-5);
  for (const char* held : {", {part: upper, dofs: [z]}", ", {part: lower, dofs: [z]}",
                           ", {part: lower, dofs: [z]}, {part: upper, dofs: [z]}"}) {
    CAPTURE(held);
    const Pulled pulled = pull_lap_joint(held);
    CHECK(pulled.end == Approx(loose.end).epsilon(0.15));
    CHECK(pulled.tie <= 1e-4 * pulled.pull);
    CHECK(pulled.pull > loose.pull);  // the loose one bends and gives way
    CHECK(pulled.pull < 1.5 * loose.pull);
  }
}

TEST_CASE("nodes that are not tied make contact under general contact, and none where it excludes the pair", "[law]") {
  Simulation held = swinging_plate("{between: all}");
  const Seen contact = swing(held);
  CHECK(contact.pushes >= 9);                                  // the far edge of the plate at least
  CHECK(contact::collect(*held.contact).penetration <= 1e-4);  // of nodes in contact: a hundredth of an element
  Simulation loose = swinging_plate("{between: all, exclude: [[base, plate]]}");
  const Seen alone = swing(loose);
  CHECK(alone.pushes == 0);
  CHECK(alone.lowest <= -0.002);  // below the whole far end of the base
}
