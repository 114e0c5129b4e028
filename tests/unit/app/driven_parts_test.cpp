// SPDX-License-Identifier: Apache-2.0
// Parts that supports move through each other or through walls: reported once, with the depth that they come to.
#include "app/state/driven_parts.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "unit/app/prepared_scene.hpp"

using namespace brunt;
using support::PreparedScene;

namespace {

/// A fixed block of 6 x 6 x 3 elements, its top at z = 0.05, and one of 5 x 5 x 3 over it, 0.0001 away, moved by `how`.
std::string ram(const std::string& how, bool ram_first, double size = 1) {
  const std::string low =
      fmt::format("  - {{box: {{part: a, size: [0.1, 0.1, 0.05], elements: [6, 6, 3], scale: {}}}}}\n", size);
  const std::string top =
      fmt::format("  - {{box: {{part: b, size: [0.1, 0.1, 0.05], elements: [5, 5, 3], scale: {}, at: [0, 0, {}]}}}}\n",
                  size, 0.0501 * size);
  return "units: SI\nmesh:\n" + (ram_first ? top + low : low + top) +
         "materials: {s: {model: neo_hookean, density: 1100, bulk: 1.0e8, shear: 1.0e7}}\n"
         "parts: {a: {material: s}, b: {material: s}}\nrun: {steps: 1}\n" +
         how;
}

struct Looked {
  std::vector<std::string> warnings;
  double depth = 0;
};

Looked run_to(const std::string& text, double end) {
  PreparedScene scene(text);
  app::Prepared& run = *scene.run;
  Looked looked;
  const auto look = [&] {
    for (std::string& line : run.driven.look(run.links.ranks, *run.contact, run.model, run.state, "m"))
      looked.warnings.push_back(std::move(line));
  };
  while (run.state.time < end) {
    scene.evaluate();
    scene.advance();
    if (static_cast<int>(run.state.step) % 50 == 0) look();
  }
  look();
  looked.depth = run.driven.largest();
  return looked;
}

}  // namespace

TEST_CASE("driven parts: a ram that is moved through a fixed block is followed beyond contact's reach") {
  const bool ram_first = GENERATE(false, true);
  const std::string slave = GENERATE("", ", slave: a", ", slave: b");
  const double size = GENERATE(1.0, 1e-3);
  CAPTURE(ram_first, slave, size);
  const double end = 2e-3 * size;  // 0.02 of travel: an element is 0.0167 long
  const Looked looked =
      run_to(ram("fixed: [{part: a, dofs: [x, y, z]}]\nprescribed: [{part: b, dof: z, velocity: -10}]\n"
                 "contact: [{between: [a, b]" +
                     slave + "}]\n",
                 ram_first, size),
             end);
  REQUIRE(looked.warnings.size() == 1);
  CHECK_THAT(looked.warnings[0], Catch::Contains("'a'") && Catch::Contains("'b'") && Catch::Contains("since t = "));
  CHECK(looked.depth == Approx(0.0199 * size).epsilon(0.01));
}

TEST_CASE("driven parts: none where one of the two can give way, or where they do not meet") {
  const std::string free =
      GENERATE("prescribed: [{part: b, dof: z, velocity: -10}]\n",
               "fixed: [{part: a, dofs: [x, y]}]\nprescribed: [{part: b, dof: z, velocity: -10}]\n",
               "fixed: [{part: a, dofs: [x, y, z]}]\nprescribed: [{part: b, dof: z, velocity: 10}]\n",
               "fixed: [{part: a, dofs: [x, y, z]}]\nprescribed: [{part: b, dof: x, velocity: 10}]\n");
  const Looked looked = run_to(ram(free + "contact: [{between: all}]\n", false), 5e-4);
  CHECK(looked.warnings.empty());
  CHECK(looked.depth == 0);
}

TEST_CASE("driven parts: a part that is moved into a rigid wall, and a wall that moves into a fixed part") {
  const std::string how = GENERATE(
      "prescribed: [{part: a, dof: z, velocity: -10}]\nrigid_walls: [{name: w, point: [0, 0, 0], "
      "normal: [0, 0, 1]}]\n",
      "fixed: [{part: a, dofs: [x, y, z]}]\ncurves: {up: [[0, 10], [1, 10]]}\n"
      "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1], motion: up}]\n");
  const Looked looked = run_to(ram(how, false), 1e-3);
  REQUIRE(looked.warnings.size() == 1);
  CHECK_THAT(looked.warnings[0], Catch::Contains("rigid wall 'w'") && Catch::Contains("'a'"));
  CHECK(looked.depth == Approx(0.01).epsilon(0.03));  // as it was before the last step of 0.00025
}

TEST_CASE("driven parts: scenes in which supports hold nothing of the surface have nothing to save") {
  PreparedScene scene(ram("contact: [{between: all}]\n", false));
  CHECK(scene.run->driven.saved().empty());
}
