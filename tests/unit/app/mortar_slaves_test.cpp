// SPDX-License-Identifier: Apache-2.0
#include "app/whole/mortar_slaves.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/read/read.hpp"

using namespace brunt;

namespace {

/// A long bar of 8 elements of length 1 and a cube of 2^3 elements on or above its end.
std::vector<mesh::Side> slaves(const std::string& contact, double height = 0) {
  const scene::Input input = scene::read_scene(
      "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\nsolver: {scheme: static, step: 1}\n"
      "materials: {m: {model: neo_hookean, density: 1, young: 1, poisson: 0}}\n"
      "parts: {bar: {material: m, element: hex8_full}, cube: {material: m, element: hex8_full}}\n" +
          contact,
      "scene of the test");
  mesh::Mesh mesh = mesh::box("bar", Vec3(8, 1, 1), {8, 1, 1});
  mesh::Mesh cube = mesh::box("cube", Vec3(1, 1, 1), {2, 2, 2});
  for (Vec3& x : cube.coordinates) x.z() += 1 + height;
  mesh::append(mesh, std::move(cube));
  return app::mortar_slaves(input, mesh);
}

}  // namespace

TEST_CASE("the slaves of mortar contact: the finer side, or the one that is named, near its master") {
  CHECK(slaves("").empty());
  const std::vector<mesh::Side> cube = slaves("contact: [{between: [bar, cube], method: mortar}]\n");
  CHECK(cube.size() == 24);  // all of it lies within an element's length
  CHECK(std::ranges::all_of(cube, [](const mesh::Side& side) { return side.block == 1; }));

  const std::vector<mesh::Side> bar = slaves("contact: [{between: [bar, cube], method: mortar, slave: first}]\n");
  REQUIRE(!bar.empty());
  for (const mesh::Side& side : bar) {
    CHECK(side.block == 0);
    CHECK(side.element <= 2);  // the third begins where the reach of the cube ends
  }
  CHECK(std::ranges::any_of(bar, [](const mesh::Side& side) { return side.element == 1; }));
}

TEST_CASE("where no face of a slave is near its master, all of them may be met later") {
  CHECK(slaves("contact: [{between: [bar, cube], method: mortar}]\n", 5).size() == 24);
  CHECK(slaves("contact: [{between: [bar, cube], method: mortar, slave: first}]\n", 5).size() == 34);
}
