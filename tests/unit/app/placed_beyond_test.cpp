// SPDX-License-Identifier: Apache-2.0
// Parts that a placement moves behind rigid walls or across planes of symmetry.
#include "app/whole/placed_beyond.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/read/read.hpp"

using namespace brunt;

namespace {

/// A unit cube a at the origin and a unit cube b from x = 2 on; a is moved, b stays.
std::vector<std::string> beyond_after(const std::string& walls, const Vec3& move) {
  const scene::Input input = scene::read_scene(
      "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
      "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
      "parts: {a: {material: m}, b: {material: m}}\ncontact: [{between: all, initial_overlap: place}]\n" +
          walls + "\n",
      "test.yaml");
  mesh::Mesh mesh = mesh::box("a", {1, 1, 1}, {2, 1, 1});
  mesh::Mesh other = mesh::box("b", {1, 1, 1}, {1, 1, 1});
  mesh::place(other, 1, Vec3::UnitX(), 0, Vec3(2, 0, 0));
  mesh::append(mesh, std::move(other));
  const std::vector<Vec3> before = mesh.coordinates;
  for (std::size_t i = 0; i < 12; ++i) mesh.coordinates[i] += move;
  return app::placed_beyond(input, mesh, before);
}

}  // namespace

TEST_CASE("placed beyond: a wall at any angle, by the depth of the lowest node") {
  // behind the plane through the origin by s/5 (3, 4, 0), one of s = 0.1: nodes (0, 0, z) are the lowest
  const std::string oblique = "rigid_walls: [{name: w, point: [0, 0, 7], normal: [3, 4, 0]}]";
  const std::vector<std::string> pushed = beyond_after(oblique, Vec3(-0.06, -0.08, 0.5));
  REQUIRE(pushed.size() == 1);
  CHECK(pushed[0] == "test.yaml:7: rigid_walls.0: initial_overlap: place moves part 'a' 0.1 behind rigid wall 'w'");
  CHECK(beyond_after(oblique, Vec3(0.08, -0.06, 0)).empty());  // along the wall
  CHECK(beyond_after(oblique, Vec3(0.06, 0.08, 0)).empty());
}

TEST_CASE("placed beyond: what was behind a wall before counts only where it is farther behind") {
  const std::string inside = "rigid_walls: [{name: w, point: [0.25, 0, 0], normal: [1, 0, 0]}]";
  CHECK(beyond_after(inside, Vec3(0.1, 0, 0)).empty());
  CHECK(beyond_after(inside, Vec3(0, 0.1, 0)).empty());
  CHECK_THAT(beyond_after(inside, Vec3(-0.5, 0, 0)).at(0), Catch::Contains("part 'a' 0.75 behind"));
}

TEST_CASE("placed beyond: walls of other parts, and parts that do not move, are not told") {
  CHECK(beyond_after("rigid_walls: [{name: w, point: [0, 0, 0], normal: [1, 0, 0], parts: [b]}]", Vec3(-1, 0, 0))
            .empty());
  CHECK(beyond_after("rigid_walls: [{name: w, point: [0, 0, 0], normal: [1, 0, 0], parts: [b, a]}]", Vec3(-1, 0, 0))
            .size() == 1);
  CHECK(beyond_after("rigid_walls: [{name: w, point: [9, 0, 0], normal: [1, 0, 0]}]", Vec3::Zero()).empty());
  CHECK(beyond_after("", Vec3(-1, 0, 0)).empty());
}

TEST_CASE("placed beyond: a plane of symmetry is left on the side on which the part lies, whatever its normal") {
  const std::string sign = GENERATE("", "-");
  const std::string plane = "symmetry: [{point: [-0.25, 0, 0], normal: [" + sign + "2, 0, 0]}]";
  CHECK(beyond_after(plane, Vec3(-0.2, 0, 0)).empty());
  CHECK(beyond_after(plane, Vec3(+0.5, 0, 0)).empty());
  const std::vector<std::string> crossed = beyond_after(plane, Vec3(-0.5, 0, 0));
  REQUIRE(crossed.size() == 1);
  CHECK_THAT(crossed[0], Catch::Contains("symmetry.0: ") && Catch::EndsWith("'a' 0.25 across the plane of symmetry"));
}
