// SPDX-License-Identifier: Apache-2.0
// Bodies in their places, side by side in one mesh.
#include "mesh/assemble.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using namespace brunt::mesh;

TEST_CASE("a body is scaled, then turned, then moved", "[assemble]") {
  Mesh mesh = box("b", {1, 2, 3}, {1, 1, 1});
  place(mesh, 2, Vec3::UnitZ() * 5, 90, {10, 0, 0});
  CHECK(mesh.coordinates[1] == Vec3(10, 2, 0));  // exact: (2, 0, 0) turned is (0, 2, 0)
  CHECK(mesh.coordinates[7] == Vec3(6, 2, 6));
  Mesh skew = box("b", {1, 1, 1}, {1, 1, 1});
  place(skew, 1, {1, 1, 1}, 120, Vec3::Zero());  // the axes change places
  CHECK((skew.coordinates[1] - Vec3::UnitY()).norm() < 1e-15);
  CHECK((skew.coordinates[2] - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(check(skew).faults.empty());
  CHECK_THROWS_AS(place(mesh, -1, Vec3::UnitZ(), 0, Vec3::Zero()), InputError);
  CHECK_THROWS_AS(place(mesh, 1, Vec3::Zero(), 0, Vec3::Zero()), InputError);
  CHECK_THROWS_AS(place(mesh, 1, Vec3::UnitZ(), 0, {0, NAN, 0}), InputError);
}

TEST_CASE("appended bodies stay apart and keep their sets", "[assemble]") {
  Mesh whole;
  append(whole, box("left", {1, 1, 1}, {1, 1, 1}));
  Mesh right = box("right", {1, 1, 1}, {2, 1, 1});
  place(right, 1, Vec3::UnitZ(), 0, {1, 0, 0});
  append(whole, std::move(right));
  CHECK(whole.coordinates.size() == 8 + 12);
  CHECK(whole.node_id.back() == 20);
  CHECK(whole.blocks[1].id == 2);
  CHECK(whole.blocks[1].element_id == std::vector<GlobalIndex>{2, 3});
  CHECK(bodies(whole) == std::vector<std::int32_t>{0, 1, 1});
  for (const LocalIndex n : whole.node_sets.at("right_xmax"))
    CHECK(whole.coordinates[static_cast<std::size_t>(n)][0] == 2);
  CHECK(whole.side_sets.at("right_xmax") == std::vector<Side>{{1, 1, 1}});
  CHECK(check(whole).warnings.empty());  // coincident nodes of two bodies are no crack
}

TEST_CASE("names that clash need a prefix", "[assemble]") {
  Mesh read = box("", {1, 1, 1}, {1, 1, 1});
  read.node_sets.clear();
  read.side_sets.clear();
  read.node_sets["3"] = {0};
  Mesh whole;
  append(whole, Mesh(read));
  try {
    append(whole, Mesh(read));
    FAIL("accepted");
  } catch (const InputError& error) {
    REQUIRE(error.faults().size() == 2);
    CHECK(error.faults()[0] ==
          "invalid block 1: two meshes have it; expected different names, by prefix or another part name");
    CHECK(error.faults()[1] ==
          "invalid node set 3: two meshes have it; expected different names, by prefix or another part name");
  }
  append(whole, Mesh(read), "b_");
  CHECK(whole.blocks[1].name == "b_1");
  CHECK(whole.blocks[1].id == 2);
  CHECK(whole.node_sets.at("b_3") == std::vector<LocalIndex>{8});
}
