// SPDX-License-Identifier: Apache-2.0
// What explicit and implicit scenes may not have of each other: one line a fault.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

std::vector<std::string> faults(const std::string& more, const std::string& solver = "solver: implicit\n") {
  try {
    scene::read_scene(
        fmt::format("units: none\nmesh: {{file: of_the_test}}\n"
                    "materials: {{m: {{model: neo_hookean, density: 1, young: 1, poisson: 0.3}}, "
                    "r: {{model: rigid, density: 1}}}}\n"
                    "parts: {{a: {{block: a, material: m, element: hex8_full}}, b: {{block: b, material: m, element: "
                    "hex8_full}}, c: {{block: c, material: r}}}}\n{}{}",
                    solver, more),
        "scene.yaml");
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

}  // namespace

TEST_CASE("implicit rules: keys of explicit scenes are refused, each in a line that names the other") {
  CHECK(faults("run: {end: 1}\n").empty());
  const std::vector<std::string> told = faults("run: {end: 1, cfl: 0.5}\ndamping: {alpha: 1}\n");
  REQUIRE(told.size() == 2);
  CHECK_THAT(told[0], Contains("scene.yaml:6: run.cfl: ") && Contains("expected solver.step"));
  CHECK_THAT(told[1], Contains("damping: invalid in an implicit scene"));
}

TEST_CASE("implicit rules: contact is mortar contact in implicit scenes, and not in explicit ones") {
  REQUIRE(faults("run: {end: 1}\ncontact: [{between: [a, b]}]\n").size() == 1);
  CHECK(faults("run: {end: 1}\ncontact: [{between: [a, b], method: mortar}]\n").empty());
  const auto told = faults("run: {end: 1}\ncontact: [{between: [a, b], method: mortar}]\n", "");
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Contains("mortar contact exists in implicit scenes only"));
  const auto offset = faults("run: {end: 1}\ncontact: [{between: [a, b], method: mortar, initial_overlap: offset}]\n");
  REQUIRE(offset.size() == 1);
  CHECK_THAT(offset[0], Contains("offset in an implicit scene"));
}

TEST_CASE("implicit rules: rigid bodies need a scheme that rotates them") {
  CHECK(faults("run: {end: 1}\n", "solver: {scheme: static}\n").empty());
  for (const char* scheme : {"hht", "newmark"}) {
    const auto told = faults("run: {end: 1}\n", fmt::format("solver: {{scheme: {}}}\n", scheme));
    REQUIRE(told.size() == 1);
    CHECK_THAT(told[0], Contains("solver.scheme: invalid scheme for rigid parts"));
  }
}

TEST_CASE("implicit rules: no removals, one coefficient of friction of walls") {
  const auto told = faults(
      "run: {end: 1}\nremove: [{part: a, at: 1}]\n"
      "rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: {static: 1, kinetic: 0.5, decay: 1}}]\n");
  REQUIRE(told.size() == 2);
  CHECK_THAT(told[0], Contains("remove: invalid in an implicit scene"));
  CHECK_THAT(told[1], Contains("rigid_walls.0.friction: invalid friction of a wall"));
}
