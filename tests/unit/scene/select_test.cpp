// SPDX-License-Identifier: Apache-2.0
// What a scene selects in its mesh, and what is told of selections that the mesh does not have: the line and key of the
// scene, what is wrong, what is accepted.
#include "scene/build/select.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "mesh/assemble.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/primitives.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using namespace brunt::scene;

namespace {

/// Two rows of cubes at x = 0 and 3, from files as far as the scene knows; entries start in line 6.
Input scene_with(const std::string& entries, const std::string& parts = "{low: {material: m}, top: {material: m}}") {
  return read_scene(
      "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
      "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
      "parts: " +
          parts + "\n" + entries,
      "two.yaml");
}

mesh::CanonicalMesh two_boxes() {
  mesh::Mesh whole;
  mesh::append(whole, mesh::box("low", Vec3(1, 1, 2), {1, 1, 2}), "");
  mesh::Mesh top = mesh::box("top", Vec3(1, 1, 1), {1, 1, 1});
  mesh::place(top, 1, {0, 0, 1}, 0, {3, 0, 0});
  top.node_sets["7"] = {0};                           // one node and
  top.side_sets["7"] = top.side_sets.at("top_zmax");  // four, under one number
  mesh::append(whole, std::move(top), "");
  return mesh::canonical_order(std::move(whole));
}

std::vector<std::string> faults_of(const Input& input) {
  mesh::CanonicalMesh whole = two_boxes();
  try {
    select(input, whole);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

void check_fault(const std::string& entries, const std::string& where, const std::vector<std::string>& told) {
  const std::vector<std::string> faults = faults_of(scene_with(entries));
  INFO(entries << "\nfaults:\n" << InputError(faults).what());
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Catch::StartsWith(where + ": "));
  CHECK_THAT(faults[0], Catch::Contains("expected "));
  for (const std::string& phrase : told) CHECK_THAT(faults[0], Catch::Contains(phrase));
}

}  // namespace

TEST_CASE("select: a name that the mesh does not have is told with its line and what there is", "[scene]") {
  check_fault("sets: {foot: {part: low}}\nfixed:\n  - {set: food, dofs: [x]}\n", "two.yaml:8: fixed.0.set",
              {"unknown part or set 'food'", "did you mean 'foot'?", "parts: low, top", "low_zmin"});
  check_fault("initial:\n  - set: lwo\n    velocity: [0, 0, 1]\n", "two.yaml:7: initial.0.set",
              {"unknown part or set 'lwo'", "did you mean 'low'?"});
  check_fault("pressure:\n  - {set: low_zmx, value: 1}\n", "two.yaml:7: pressure.0.set",
              {"unknown side set 'low_zmx'", "did you mean 'low_zmax'?", "top_xmin"});
  check_fault("probes:\n  - {name: tip, node: 99, field: velocity}\n", "two.yaml:7: probes.0.node",
              {"unknown node 99", "20 nodes", "from 1 to 20"});
  check_fault("symmetry:\n  - {point: [0, 0, 9], normal: [0, 0, 1]}\n", "two.yaml:7: symmetry.0",
              {"it contains no node", "from (0, 0, 0) to (4, 1, 2)"});
  check_fault("sets:\n  far: {box: [[7, 7, 7], [8, 8, 8]]}\nfixed:\n  - {set: far, dofs: [x]}\n",
              "two.yaml:9: fixed.0.set", {"'far' contains no node", "from (0, 0, 0) to (4, 1, 2)"});
}

TEST_CASE("select: a set that names none of the mesh is told once, where it is defined, used or not", "[scene]") {
  const std::string wrong = "sets:\n  load: {side_set: low_zmx}\n";
  for (const char* use : {"", "pressure: [{set: load, value: 1}]\n", "fixed: [{set: load, dofs: [x]}]\n"})
    check_fault(wrong + use, "two.yaml:7: sets.load.side_set",
                {"unknown side set 'low_zmx'", "did you mean 'low_zmax'?", "top_zmin"});
  check_fault("sets:\n  a: {part: low}\n  load: {node_set: 8}\n", "two.yaml:8: sets.load.node_set",
              {"unknown node set '8'"});
}

TEST_CASE("select: a set named as one of the mesh is a fault, unless it is the same one", "[scene]") {
  check_fault("sets:\n  low_zmin: {part: low, box: [[0, 0, 0], [1, 1, 1]]}\n", "two.yaml:7: sets.low_zmin",
              {"set of this name"});
  check_fault("sets: {low_zmin: {side_set: top_zmin}}\n", "two.yaml:6: sets.low_zmin", {"set of this name"});
  CHECK(faults_of(scene_with("sets: {low_zmin: {side_set: low_zmin}}\n")).empty());
}

TEST_CASE("select: node sets and side sets of one number are two things", "[scene]") {
  mesh::CanonicalMesh whole = two_boxes();
  select(scene_with("sets: {n: {node_set: 7}, s: {side_set: 7}}\n"
                    "fixed: [{set: n, dofs: [x]}, {set: s, dofs: [x]}]\n"),
         whole);
  CHECK(whole.mesh.node_sets.at(selection_name("fixed", 0)).size() == 1);
  CHECK(whole.mesh.node_sets.at(selection_name("fixed", 1)).size() == 4);
}

TEST_CASE("select: blocks and parts that do not fit are told with the line of the part", "[scene]") {
  const auto faults = [](const std::string& parts) { return faults_of(scene_with("", parts)); };
  const std::vector<std::string> misnamed = faults("{low: {material: m}, tpo: {material: m}}");
  REQUIRE(misnamed.size() == 2);
  CHECK_THAT(misnamed[0], Catch::Contains("two.yaml:5: parts.tpo.block: unknown block 'tpo' of the mesh; expected ") &&
                              Catch::Contains("(low)") && Catch::Contains("(top)"));
  CHECK_THAT(misnamed[1], Catch::Contains("two.yaml:5: parts: missing part for block ") && Catch::Contains("(top)") &&
                              Catch::Contains("missing part for block"));
  const std::vector<std::string> shape = faults("{low: {material: m, element: tet4}, top: {material: m}}");
  REQUIRE(shape.size() == 1);
  CHECK_THAT(shape[0],
             Catch::Contains("two.yaml:5: parts.low.element: invalid element tet4") && Catch::Contains("hex8"));
}

// The boxes reach from x = 0 to 1 and from 3 to 4.
TEST_CASE("select: a wall with all bodies behind it is refused, at rest or moving, whether it touches them or not",
          "[scene]") {
  const std::string motion = GENERATE("", ", motion: away", ", motion: towards", ", bilateral: false");
  const std::string curves = "curves: {away: [[0, 1], [1, 1]], towards: [[0, 0], [1, -1]]}\nrigid_walls: [{";
  const auto wall = [&](const std::string& place) { return curves + place + motion + "}]"; };
  check_fault(wall("point: [-0.5, 0, 0], normal: [-1, 0, 0]"), "two.yaml:7: rigid_walls.0.normal", {"by 0.5"});
  check_fault(wall("point: [0, 7, 0], normal: [-3, 0, 0]"), "two.yaml:7: rigid_walls.0.normal", {"by 0)"});
  check_fault(wall("point: [4.25, 0, 0], normal: [1, 0, 0]"), "two.yaml:7: rigid_walls.0.normal", {"by 0.25"});
  check_fault(wall("point: [5, 0, 0], normal: [1, 1, 0]"), "two.yaml:7: rigid_walls.0.normal", {"parts"});
  CHECK(faults_of(scene_with(wall("point: [0, 0, 0], normal: [1, 0, 0]"))).empty());
  CHECK(faults_of(scene_with(wall("point: [2, 0, 0], normal: [1, 0, 0]"))).empty());  // one of the two is in front
}

TEST_CASE("select: a wall looks at the parts that it names alone", "[scene]") {
  const auto wall = [](const std::string& rest) { return "rigid_walls: [{point: " + rest + "}]"; };
  CHECK(faults_of(scene_with(wall("[-0.5, 0, 0], normal: [-1, 0, 0], parts: [low]"))).empty());
  CHECK(faults_of(scene_with(wall("[0.5, 0, 0], normal: [1, 0, 0], parts: [top]"))).empty());
  check_fault(wall("[0.5, 0, 0], normal: [1, 0, 0], parts: [top, low]"), "two.yaml:6: rigid_walls.0",
              {"passes through"});
  CHECK(faults_of(scene_with(wall("[3, 0, 0], normal: [1, 0, 0], parts: [top], bilateral: true"))).empty());
  check_fault(wall("[3, 0, 0], normal: [1, 0, 0], parts: [low], bilateral: true"), "two.yaml:6: rigid_walls.0",
              {"it contains no node"});
}

TEST_CASE("select: what is removed holds whole elements, and faces between them may come to the outside", "[scene]") {
  check_fault("remove:\n  - {set: food, at: 0}\n", "two.yaml:7: remove.0.set", {"unknown part or set 'food'"});
  check_fault("sets: {rim: {part: low, box: [[0, 0, 0], [1, 1, 0]]}}\nremove:\n  - {set: rim, at: 0}\n",
              "two.yaml:8: remove.0.set", {"'rim' contains no complete deformable element"});
  check_fault("sets: {far: {box: [[7, 7, 7], [8, 8, 8]]}}\nremove:\n  - {set: far, at: 0}\n",
              "two.yaml:8: remove.0.set", {"'far' contains no node"});

  mesh::CanonicalMesh whole = two_boxes();
  select(scene_with("sets: {upper: {part: low, box: [[0, 0, 1], [1, 1, 2]]}}\n"
                    "remove: [{set: upper, at: 1}, {part: top, at: 0}]\n"),
         whole);
  CHECK(whole.mesh.node_sets.at(selection_name("remove", 0)).size() == 8);
  CHECK(whole.mesh.node_sets.at(selection_name("remove", 1)).size() == 8);
  CHECK(whole.mesh.side_sets.at(mesh::inner_faces).size() ==
        2);  // the two sides of the one face between the cubes of `low`
}
