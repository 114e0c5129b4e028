// SPDX-License-Identifier: Apache-2.0
// A plate tied along one end that swings down onto what it is tied to: the other nodes make contact, or nothing does.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
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
    for (std::size_t q = 0; q < pair.contact->rows().size(); ++q)
      if (!std::isinf(pair.contact->rows()[q].friction) && !pair.contact->impulses()[q].isZero(0)) ++pushes;
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

}  // namespace

TEST_CASE("nodes that are not tied make contact under general contact, and none where it excludes the pair") {
  Simulation held = swinging_plate("{between: all}");
  const Seen contact = swing(held);
  CHECK(contact.pushes >= 9);                          // the far edge of the plate at least
  CHECK(held.contact->collect().penetration <= 1e-4);  // of nodes in contact: a hundredth of an element
  Simulation loose = swinging_plate("{between: all, exclude: [[base, plate]]}");
  const Seen alone = swing(loose);
  CHECK(alone.pushes == 0);
  CHECK(alone.lowest <= -0.002);  // below the whole far end of the base
}
