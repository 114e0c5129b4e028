// SPDX-License-Identifier: Apache-2.0
// The coarser side named as slave is told, where the two can meet and nothing else holds the finer one.
#include "app/whole/coarse_slave_warnings.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using Catch::Matchers::Contains;

namespace {

std::vector<std::string> warnings_of(mesh::Mesh mesh, mesh::Mesh fine, const std::string& entry,
                                     const std::string& motion) {
  mesh::append(mesh, std::move(fine));
  const scene::Input input = scene::read_scene(
      "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
      "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
      "parts: {coarse: {material: m}, fine: {material: m}}\n" +
          motion + "contact: [" + entry + "]\n",
      "scene.yaml");
  mesh::CanonicalMesh whole = mesh::canonical_order(std::move(mesh));
  scene::select(input, whole);
  return app::warn_of_coarse_slaves(input, whole);
}

/// A cube `fine` of n x n x n elements over a cube `coarse` of one, both of side 1.
std::vector<std::string> warnings(const std::string& entry, std::int32_t n, double gap = 0.1,
                                  const std::string& motion = "") {
  mesh::Mesh fine = mesh::box("fine", {1, 1, 1}, {n, n, n});
  mesh::place(fine, 1, {0, 0, 1}, 0, {0, 0, 1 + gap});
  return warnings_of(mesh::box("coarse", {1, 1, 1}, {1, 1, 1}), std::move(fine), entry, motion);
}

}  // namespace

TEST_CASE("coarse slaves: a slave with edges more than twice as long is told, with sizes and remedies") {
  const std::vector<std::string> told = warnings("{between: [coarse, fine], slave: coarse}", 4);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0],
             Catch::Matches("scene\\.yaml:[0-9]+: contact\\.0\\.slave: part 'coarse' is the slave of 'fine'.*"));
  CHECK_THAT(told[0], Contains("(edges of 0.25 against 1)"));
  CHECK_THAT(told[0], Contains("use slave: fine, or passes: two"));
  CHECK(warnings("{between: [coarse, fine], slave: coarse, passes: one}", 4) == told);
  CHECK(warnings("{between: [fine, coarse], slave: second}", 4) == told);
}

TEST_CASE("coarse slaves: nothing is told of finer slaves, of meshes alike, of two passes, or where contact chooses") {
  CHECK(warnings("{between: [coarse, fine], slave: fine}", 4).empty());
  CHECK(warnings("{between: [coarse, fine], slave: coarse}", 2).empty());
  CHECK(warnings("{between: [coarse, fine], slave: coarse, passes: two}", 4).empty());
  CHECK(warnings("{between: [coarse, fine]}", 4).empty());
  CHECK(warnings("{between: [coarse, fine], slave: coarse}, {between: all}", 4).empty());
  CHECK(warnings("{between: [coarse, fine], slave: coarse}, {between: all, exclude: [[coarse, fine]]}", 4).empty());
}

TEST_CASE("coarse slaves: either side carries a tie, whose weights are integrated") {
  CHECK(warnings("{between: [coarse, fine], slave: coarse, tied: true}", 4).empty());
}

TEST_CASE("coarse slaves: a part that flies towards the other from afar is measured where it will meet it") {
  const std::string motion = "initial: [{part: fine, velocity: [0, 0, -100]}]\n";
  CHECK(warnings("{between: [coarse, fine], slave: coarse}", 4, 20, motion).size() == 1);
}

TEST_CASE("coarse slaves: what counts are the faces that can meet") {
  // a bar of long elements stands on a block with its end, which is as fine as the block; its sides are near it
  mesh::Mesh fine = mesh::box("fine", {4, 4, 1}, {8, 8, 2});
  mesh::place(fine, 1, {0, 0, 1}, 0, {-1.5, -1.5, -1});
  const std::string entry = "{between: [coarse, fine], slave: coarse}";
  CHECK(warnings_of(mesh::box("coarse", {1, 1, 12}, {2, 2, 4}), fine, entry, "").empty());
  CHECK(warnings_of(mesh::box("coarse", {3, 3, 12}, {2, 2, 4}), fine, entry, "").size() == 1);
}
