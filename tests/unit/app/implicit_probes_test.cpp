// SPDX-License-Identifier: Apache-2.0
// What interfaces have pushed a part with: signs of slave and master, and sums over interfaces.
#include "app/report/implicit_probes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "implicit/mortar/interface_forces.hpp"
#include "implicit/solver.hpp"
#include "unit/app/prepared_scene.hpp"

using namespace brunt;

TEST_CASE("a probe of a contact sees its interfaces from the part's side") {
  support::PreparedScene scene(
      "units: none\nmesh:\n  - {box: {part: a, size: [2, 1, 1], elements: [2, 1, 1]}}\n"
      "  - {box: {part: b, size: [1, 1, 1], elements: [2, 2, 2], at: [0, 0, 1]}}\n"
      "  - {box: {part: c, size: [1, 1, 1], elements: [2, 2, 2], at: [1, 0, 1]}}\n"
      "materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}\n"
      "parts: {a: {material: m, element: hex8_full}, b: {material: m, element: hex8_full}, c: {material: m, element: "
      "hex8_full}}\n"
      "contact: [{between: [a, b], method: mortar, slave: b}, {between: [a, c], method: mortar, slave: a}]\n"
      "solver: {scheme: contact_implicit, step: 0.1}\nrun: {end: 1}\n");
  app::Prepared& run = *scene.run;
  std::vector<double>& impulses = run.implicit->contact.impulses;
  constexpr auto width = static_cast<std::size_t>(implicit::interface_force_width);
  REQUIRE(impulses.size() == 2 * width);
  const auto set = [&](std::size_t interface, double z, double size) {
    impulses[width * interface + 2] = z;
    impulses[width * interface + 6] = size;
  };
  set(0, 3, 3);   // on b, by a
  set(1, -5, 5);  // on a, by c
  CHECK(app::watched_contact(run, "b", "a").impulse == Vec3(0, 0, 3));
  CHECK(app::watched_contact(run, "a", "b").impulse == Vec3(0, 0, -3));
  CHECK(app::watched_contact(run, "a", "c").impulse == Vec3(0, 0, -5));
  CHECK(app::watched_contact(run, "a", "").impulse == Vec3(0, 0, -8));
  CHECK(app::watched_contact(run, "a", "").normal_size == 8);
  CHECK(app::watched_contact(run, "b", "c").impulse == Vec3(0, 0, 0));
}
