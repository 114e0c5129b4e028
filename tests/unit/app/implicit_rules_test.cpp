// SPDX-License-Identifier: Apache-2.0
// What implicit scenes may not ask for, and what is said of them: one line a fault.
#include "app/start/implicit_rules.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "scene/read/read.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

scene::Input input(const std::string& more, const std::string& solver = "solver: {scheme: contact_implicit}\n") {
  return scene::read_scene(
      fmt::format("units: none\nmesh: {{file: of_the_test}}\n"
                  "materials: {{m: {{model: neo_hookean, density: 1, young: 1, poisson: 0.3}}}}\n"
                  "parts: {{a: {{block: a, material: m, element: hex8_full}}, b: {{block: b, material: m, element: "
                  "hex8_full}}}}\n{}{}",
                  solver, more),
      "scene.yaml");
}

}  // namespace

TEST_CASE("implicit rules: elements without stiffness against hourglass modes are refused") {
  model::Model model;
  model.blocks.resize(1);
  model.blocks[0].part = std::string("a");
  model.blocks[0].kind = element::ElementKind::hex8;
  const auto told = app::faults_of_implicit(input("run: {end: 1}\n"), model);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Contains("parts.a.element: invalid element hex8: it has no stiffness against hourglass modes"));
}

TEST_CASE("implicit rules: what becomes of an overlap of the start depends on the scheme") {
  const auto note = [](const std::string& scheme, const std::string& more = "") {
    const auto notes = app::notes_of_overlaps(input(
        fmt::format("run: {{end: 1}}\ncontact: [{{between: [a, b], method: mortar, initial_overlap: warn{}}}]\n", more),
        fmt::format("solver: {{scheme: {}}}\n", scheme)));
    REQUIRE(notes.size() == 1);
    return notes[0];
  };
  CHECK_THAT(note("contact_implicit"),
             Contains("contact.0.initial_overlap: ") && Contains("an initial overlap remains"));
  CHECK_THAT(note("static"), Contains("the first step closes"));
  CHECK_THAT(note("static", ", enforce: penalty"), Contains("penalty pressure"));
  CHECK(app::notes_of_overlaps(input("run: {end: 1}\ncontact: [{between: [a, b], method: mortar}]\n")).empty());
}

TEST_CASE("implicit rules: causes name the step of the solver") {
  for (const app::Fault fault : {app::Fault::balance, app::Fault::damping, app::Fault::contact, app::Fault::friction}) {
    CHECK_THAT(app::likely_cause_in_implicit(fault, {}), Contains("solver.step"));
    CHECK_THAT(app::likely_cause_in_implicit(fault, {}), !Contains("run.cfl"));
  }
}
