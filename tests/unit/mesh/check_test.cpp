// SPDX-License-Identifier: Apache-2.0
// Every fault a mesh can have is found and named by the input's numbers; what is legal passes.
#include "mesh/check.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesh/primitives.hpp"

using namespace brunt;
using namespace brunt::mesh;

namespace {

Mesh one_hex(const std::vector<LocalIndex>& nodes) {
  Mesh mesh = box("b", {1, 1, 1}, {1, 1, 1});
  mesh.coordinates = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  mesh.node_id = {10, 11, 12, 13, 14, 15, 16, 17};
  mesh.blocks[0].element_id = {77};
  mesh.blocks[0].nodes = nodes;
  mesh.node_sets.clear();
  mesh.side_sets.clear();
  return mesh;
}

std::string only_fault(const Mesh& mesh) {
  const auto faults = check(mesh).faults;
  REQUIRE(faults.size() == 1);
  return faults[0];
}

}  // namespace

TEST_CASE("wedge, pyramid and tetrahedron are legal hexahedra", "[check]") {
  for (const auto& nodes : std::vector<std::vector<LocalIndex>>{{0, 1, 2, 3, 4, 5, 6, 7},
                                                                {0, 1, 2, 2, 4, 5, 6, 6},
                                                                {0, 1, 2, 3, 4, 4, 5, 5},
                                                                {0, 1, 2, 3, 4, 4, 4, 4},
                                                                {0, 1, 3, 3, 4, 4, 4, 4}})
    CHECK(check(one_hex(nodes)).faults.empty());
}

TEST_CASE("other repeats are refused", "[check]") {
  for (const auto& nodes : std::vector<std::vector<LocalIndex>>{{0, 1, 2, 2, 4, 5, 6, 7},
                                                                {0, 1, 0, 3, 4, 5, 6, 7},
                                                                {0, 1, 2, 3, 4, 5, 6, 0},
                                                                {0, 1, 1, 3, 4, 5, 6, 6},
                                                                {0, 0, 0, 0, 0, 0, 0, 0}})
    CHECK(only_fault(one_hex(nodes)) ==
          "invalid element 77 (block b): repeated nodes; expected those of a wedge, pyramid or tetrahedron");
}

TEST_CASE("inverted and flat elements are named with the place", "[check]") {
  CHECK(only_fault(one_hex({4, 5, 6, 7, 0, 1, 2, 3})).find("invalid element 77 (block b): the Jacobian at") == 0);
  Mesh dented = one_hex({0, 1, 2, 3, 4, 5, 6, 7});
  dented.coordinates[6] = {0.3, 0.3, 0.9};  // past the plane of its neighbours, the centre is still right
  CHECK(only_fault(dented).find("at node 16 is not positive") != std::string::npos);
  Mesh flat = one_hex({0, 1, 2, 3, 4, 5, 6, 7});
  for (auto& x : flat.coordinates) x[2] = 0;
  CHECK(check(flat).faults.size() == 1);
  Mesh tet = one_hex({});
  tet.blocks[0] = {"t", 1, Shape::tet4, {0, 1, 3, 4, 0, 3, 1, 4, 0, 1, 1, 4}, {1, 2, 3}};
  const auto faults = check(tet).faults;
  REQUIRE(faults.size() == 3);
  CHECK(faults[0].find("invalid element 3 (block t): repeated nodes") == 0);
  CHECK(faults[1].find("invalid element 2 (block t): the Jacobian at its centre") == 0);
  CHECK(faults[2].find("invalid element 2 (block t): it has the nodes of element 1") == 0);
}

TEST_CASE("indices and coordinates are checked before they are used", "[check]") {
  CHECK(only_fault(one_hex({0, 1, 2, 3, 4, 5, 6, 8})) ==
        "invalid element 77 (block b): corner 8 refers to node position 9; expected 1 to 8");
  Mesh infinite = one_hex({0, 1, 2, 3, 4, 5, 6, 7});
  infinite.coordinates[2][1] = NAN;
  CHECK(only_fault(infinite).find("invalid node 12: coordinates") == 0);
  Mesh sets = one_hex({0, 1, 2, 3, 4, 5, 6, 7});
  sets.node_sets["n"] = {-1};
  sets.side_sets["s"] = {{0, 0, 6}, {1, 0, 0}, {0, 1, 0}};
  CHECK(check(sets).faults.size() == 4);
  Mesh empty = one_hex({});
  empty.blocks[0].element_id.clear();
  CHECK(only_fault(empty) == "invalid block b: it has no elements; expected at least one");
  CHECK(only_fault(Mesh{}) == "missing element blocks; expected at least one");
}

TEST_CASE("a long list of faults is cut and counted", "[check]") {
  Mesh mesh = box("b", {1, 1, 1}, {3, 3, 3});
  for (auto& x : mesh.coordinates) x[0] = -x[0];
  const auto faults = check(mesh).faults;
  REQUIRE(faults.size() == 11);
  CHECK(faults.back() == "... and 17 more lines like the one above");
}

TEST_CASE("unused and coincident nodes are warnings", "[check]") {
  Mesh mesh = one_hex({0, 1, 2, 2, 4, 5, 6, 6});
  mesh.node_sets["some"] = {0, 3, 7};
  CHECK(check(mesh).warnings ==
        std::vector<std::string>{"2 nodes belong to no element and are excluded (the first is node 13); node set "
                                 "some loses 2 of its 3 nodes"});
  Mesh cracked = box("b", {2, 1, 1}, {2, 1, 1});
  cracked.coordinates.push_back(cracked.coordinates[1]);
  cracked.node_id.push_back(13);
  cracked.blocks[0].nodes[8] = 12;  // the second element has a corner of its own
  CHECK(check(cracked).warnings == std::vector<std::string>{"1 nodes coincide with another node of the same body (for "
                                                            "example nodes 2 and 13): the mesh has a crack there"});
}
