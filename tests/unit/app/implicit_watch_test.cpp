// SPDX-License-Identifier: Apache-2.0
// Which implicit steps are inadmissible by the positions at their end and on the way, and which scenes are not watched.
#include "app/watch/implicit_watch.hpp"

#include <catch2/catch.hpp>

#include "prepared_scene.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

/// A block of 6 x 6 x 4 unit elements, its top at z = 4, and a cube of one element of edge .8 over it.
std::string cube_over_block(double gap, const std::string& contact) {
  return "units: none\nmesh:\n"
         "  - {box: {part: low, size: [6, 6, 4], elements: [6, 6, 4]}}\n"
         "  - {box: {part: top, size: [0.8, 0.8, 0.8], elements: [1, 1, 1], at: [2.1, 2.1, " +
         std::to_string(4 + gap) +
         "]}}\n"
         "materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}\n"
         "parts: {low: {material: m, element: hex8_full}, top: {material: m, element: hex8_full}}\n"
         "solver: {step: 0.1}\nrun: {end: 1}\n" +
         contact;
}
const std::string mortar = "contact: [{between: [low, top], method: mortar}]\n";

/// Of a step that moves the cube by `way`.
std::string objection(double gap, const Vec3& way, const std::string& contact = mortar) {
  support::PreparedScene scene(cube_over_block(gap, contact));
  for (int corner = 0; corner < 8; ++corner) {
    const LocalIndex node = scene.run->model.blocks[1].corner_node(0, corner);
    for (int c = 0; c < 3; ++c) scene.run->state.nodes[static_cast<std::size_t>(node)].x[c] += way[c];
  }
  return app::objection_to_step(*scene.run);
}

}  // namespace

TEST_CASE("a step into a body or through it is inadmissible") {
  CHECK_THAT(objection(0.5, {0, 0, -1}), Contains("deeper by more than 0.2 of an element"));
  CHECK_THAT(objection(0.5, {0, 0, -6}), Contains("deeper by more than 0.2 of an element"));  // out again below
  CHECK_THAT(objection(0.5, {0.3, 0.2, -6}), Contains("part 'top'"));
  CHECK_THAT(objection(0.5, {0, 0, -40}), Contains("'low' and 'top' move past each other by more than 32"));
}

TEST_CASE("steps beside a body, onto it, along it and away from it are admissible") {
  CHECK(objection(0.5, {0, 0, 40}).empty());
  CHECK(objection(0.5, {20, 0, -0.5}).empty());
  CHECK(objection(0.1, {0, 0, -0.2}).empty());  // a tenth deep: warned of elsewhere
  CHECK(objection(0.0, {2, 1, 0}).empty());
  CHECK(objection(-0.3, {1, 0, 0}).empty());  // as deep as before
  CHECK(objection(-0.3, {0, 0, 0.3}).empty());
}

TEST_CASE("bodies without mortar contact and tied ones are not watched") {
  CHECK(objection(0.5, {0, 0, -1}, "").empty());
  CHECK(objection(0.0, {0, 0, -1}, "contact: [{between: [low, top], method: mortar, tied: true}]\n").empty());
}
