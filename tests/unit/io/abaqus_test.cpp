// SPDX-License-Identifier: Apache-2.0
// Small Abaqus input files, in one piece and as parts with instances, and what is refused with its line.
#include "io/mesh/abaqus.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "abaqus_text.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using test::fault_of;
using test::read;

namespace {

/// A cube, a wedge beside it, a pyramid on top of the cube and a tetrahedron apart, with every face as a surface.
const std::string pieces = R"(*HEADING
anything
** a comment
*Node, NSET=Everything
1, 0., 0., 0.
2, 1., 0, 0
3, 1.D0, +1., 0
4, 0, 1.0e+00
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
9, 2, 0, 0
10, 2, 0, 1
11, .5, .5, 2
21, 5, 0, 0
22, 6, 0, 0
23, 5, 1, 0
24, 5, 0, 1
*ELEMENT, TYPE=C3D8R, ELSET=Body
1, 1, 2, 3, 4,
 5, 6, 7, 8
*Element, type=C3D6, elset=BODY
2, 2, 9, 3, 6, 10, 7
*Element, type=C3D5, elset=cap
3, 5, 6, 7, 8, 11
*Element, type=C3D4, elset=body
4, 21, 22, 23, 24
*Element, type=CPS4, elset=skin
5, 1, 2, 3, 4
*Nset, nset=ends, generate
1, 9, 4
*Nset, nset=more
ends, 24
)";

/// Area vector of a side set's faces, one by one.
Vec3 area_of(const mesh::Mesh& mesh, const mesh::Side& side) {
  const mesh::Block& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  const auto nodes = mesh::face_nodes(block.shape, block.element(side.element), side.face);
  const auto at = [&](std::size_t k) { return mesh.coordinates[static_cast<std::size_t>(nodes[k])]; };
  Vec3 area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
  if (nodes[3] != no_index) area += 0.5 * (at(2) - at(0)).cross(at(3) - at(0));
  return area;
}

const std::string two_of_one = R"(*Part, name=Brick
*Node
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
99, 7, 7, 7
*Element, type=C3D8
10, 1, 2, 3, 4, 5, 6, 7, 8
*Elset, elset=All
10,
*Nset, nset=Bottom
1, 2, 3, 4
*Solid Section, elset=ALL, material=steel
,
*End Part
*Assembly, name=A
*Instance, name=Left, part=brick
*End Instance
*Instance, name=Right, part=Brick
3, 0, 0
3, 0, 0, 3, 0, 1, 90
*End Instance
*Node
1, 0, 0, 9
*Nset, nset=Reference
1,
*Elset, elset=_top, instance=Right
10,
*Surface, type=ELEMENT, name=Top
_top, S2
*Surface, name=Skin
Left.All,
*Nset, nset=Foot, instance=Left
Bottom
*Nset, nset=Foot, instance=Right
1, 4
*End Assembly
*Material, name=steel
*Density
1,
*Step
*Nset, nset=later
Left.1,
*End Step
)";

}  // namespace

TEST_CASE("abaqus: solids of all shapes, sets by number, range and name") {
  const mesh::Mesh mesh = read(pieces);
  REQUIRE(mesh.blocks.size() == 3);
  CHECK(mesh.blocks[0].name == "Body");
  CHECK(mesh.blocks[0].count() == 2);
  CHECK(mesh.blocks[1].name == "cap");
  CHECK(mesh.blocks[2].name == "Body_tet4");
  CHECK(mesh.blocks[2].shape == mesh::Shape::tet4);
  CHECK(mesh.blocks[2].element_id == std::vector<GlobalIndex>{4});
  CHECK(mesh.coordinates[2] == Vec3(1, 1, 0));
  CHECK(mesh.coordinates[10] == Vec3(0.5, 0.5, 2));
  CHECK(mesh.node_id[11] == 21);
  CHECK(mesh.node_sets.at("Everything").size() == 15);
  CHECK(mesh.node_sets.at("ends") == std::vector<LocalIndex>{0, 4, 8});
  CHECK(mesh.node_sets.at("more") == std::vector<LocalIndex>{0, 4, 8, 14});
}

TEST_CASE("abaqus: faces have the manual's numbers") {
  struct Known {
    const char* face;
    Vec3 area;  // half of the sum of cross products, by hand
  };
  const std::vector<Known> known{
      {"1, S1", {0, 0, -1}},      {"1, S2", {0, 0, 1}},      {"1, S3", {0, -1, 0}},      {"1, S4", {1, 0, 0}},
      {"1, S5", {0, 1, 0}},       {"1, S6", {-1, 0, 0}},     {"2, S1", {0, 0, -0.5}},    {"2, S2", {0, 0, 0.5}},
      {"2, S3", {0, -1, 0}},      {"2, S4", {1, 1, 0}},      {"2, S5", {-1, 0, 0}},      {"3, S1", {0, 0, -1}},
      {"3, S2", {0, -0.5, 0.25}}, {"3, S3", {0.5, 0, 0.25}}, {"3, S4", {0, 0.5, 0.25}},  {"3, S5", {-0.5, 0, 0.25}},
      {"4, S1", {0, 0, -0.5}},    {"4, S2", {0, -0.5, 0}},   {"4, S3", {0.5, 0.5, 0.5}}, {"4, S4", {-0.5, 0, 0}},
  };
  for (const Known& one : known) {
    CAPTURE(one.face);
    const mesh::Mesh mesh = read(fmt::format("{}*Surface, name=face\n{}\n", pieces, one.face));
    REQUIRE(mesh.side_sets.at("face").size() == 1);
    CHECK((area_of(mesh, mesh.side_sets.at("face")[0]) - one.area).norm() < 1e-15);
    CHECK(mesh.node_sets.at("face").size() >= 3);
  }
  const mesh::Mesh mesh = read(pieces + "*Surface, name=skin\nBODY,\n*Surface, type=NODE, name=points\nends\n24,\n");
  CHECK(mesh.side_sets.at("skin").size() == 4 + 4 + 4);  // cube and wedge share a face, the pyramid hides another
  CHECK(mesh.node_sets.at("points") == std::vector<LocalIndex>{0, 4, 8, 14});
  CHECK(!mesh.side_sets.contains("points"));
}

TEST_CASE("abaqus: parts stand where their instances are, with names of their own") {
  const mesh::Mesh mesh = read(two_of_one);
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[0].name == "Left.All");
  CHECK(mesh.blocks[1].name == "Right.All");
  CHECK(mesh.node_id.back() == 18);
  CHECK(mesh.blocks[1].element_id == std::vector<GlobalIndex>{2});
  CHECK((mesh.coordinates[9 + 1] - Vec3(3, 1, 0)).norm() < 1e-15);  // the right one's second node, turned
  CHECK(mesh.node_sets.at("Left.Bottom") == std::vector<LocalIndex>{0, 1, 2, 3});
  CHECK(mesh.node_sets.at("Foot") == std::vector<LocalIndex>{0, 1, 2, 3, 9, 12});
  CHECK(mesh.node_sets.at("later") == std::vector<LocalIndex>{0});
  CHECK(!mesh.node_sets.contains("Reference"));
  REQUIRE(mesh.side_sets.at("Top").size() == 1);
  CHECK((area_of(mesh, mesh.side_sets.at("Top")[0]) - Vec3(0, 0, 1)).norm() < 1e-15);
  CHECK(mesh.side_sets.at("Skin").size() == 6);
}

TEST_CASE("abaqus: one instance keeps its numbers; what stands outside of parts has no prefix") {
  std::string one = two_of_one;
  const auto second = one.find("*Instance, name=Right");
  one.erase(second, one.find("*Node", second) - second);
  for (const char* of_the_other :
       {"*Elset, elset=_top, instance=Right\n10,\n", "*Surface, type=ELEMENT, name=Top\n_top, S2\n",
        "*Nset, nset=Foot, instance=Right\n1, 4\n"})
    one.erase(one.find(of_the_other), std::string(of_the_other).size());
  const mesh::Mesh mesh = read(one);
  CHECK(mesh.node_id[8] == 99);
  CHECK(mesh.blocks[0].name == "Left.All");
  CHECK(mesh.blocks[0].element_id == std::vector<GlobalIndex>{10});
}

TEST_CASE("abaqus: what is wrong is told with its line") {
  using Catch::Contains;
  const auto with = [](const std::string& more) { return fault_of(pieces + more); };
  const auto next = 1 + std::ranges::count(pieces, '\n');
  const auto at = [&](std::ptrdiff_t line) { return Contains(fmt::format(":{}:", line)); };
  CHECK_THAT(with("*Node\n1, 0, 0, 0\n"), at(next + 1) && Contains("invalid node 1: defined twice"));
  CHECK_THAT(with("*Node\n31, 0, zero, 0\n"), at(next + 1) && Contains("invalid value 'zero'; expected a coordinate"));
  CHECK_THAT(with("*Node\n31, 0, nan, 0\n"), at(next + 1) && Contains("'nan'"));
  CHECK_THAT(with("*Element, type=C3D4\n1, 1, 2, 3, 5\n"),
             at(next + 1) && Contains("invalid element 1: defined twice"));
  CHECK_THAT(with("*Element, type=C3D4\n31, 1, 2, 3, 77\n"), at(next + 1) && Contains("unknown node 77"));
  CHECK_THAT(with("*Element, type=C3D4\n31, 1, 2, 3\n"), at(next + 1) && Contains("4 nodes"));
  CHECK_THAT(with("*Element, type=C3D4\n31, 1, 2, 3, 5, 6\n"),
             at(next + 1) && Contains("invalid element 31 of 5 nodes; expected 4 nodes"));
  CHECK_THAT(with("*Element, type=C3D10\n"), at(next) && Contains("second order") && Contains("C3D8"));
  CHECK_THAT(with("*Element, type=S8R\n"), at(next) && Contains("invalid element type S8R, a shell of second order"));
  CHECK_THAT(with("*Element\n"), at(next) && Contains("element type ''"));
  CHECK_THAT(with("*Include, input=other.inp\n"),
             at(next) && Contains("included file 'other.inp'") && Contains("does not exist"));
  CHECK_THAT(with("*Nset, nset=a\nmissing\n"), at(next + 1) && Contains("unknown set 'missing'"));
  CHECK_THAT(with("*Nset\n1\n"), at(next) && Contains("missing parameter of *NSET; expected NSET=NAME"));
  CHECK_THAT(with("*Nset, nset=a, generate\n1, 1000000000\n"), at(next + 1) && Contains("out of range: 1000000000"));
  CHECK_THAT(with("*Nset, nset=a, generate\n9, 1, 1\n"), at(next + 1) && Contains("GENERATE"));
  CHECK_THAT(with("*Nset, nset=a, instance=I\n1,\n"), at(next) && Contains("unknown instance 'I'"));
  CHECK_THAT(with("*Surface, name=s\n1, S7\n"), at(next + 1) && Contains("'S7'"));
  CHECK_THAT(with("*Surface, name=s\n4, S5\n"), at(next + 1) && Contains("invalid face of element 4: it has no S5"));
  CHECK_THAT(with("*Surface, name=s\n77, S1\n"), at(next + 1) && Contains("unknown element 77 of 's'"));
  CHECK_THAT(with("*Solid Section, elset=cap\n"), Contains("missing *SOLID SECTION"));
  CHECK_THAT(with("*Solid Section, elset=none\n"), at(next) && Contains("unknown element set 'NONE'"));
  CHECK_THAT(with("*Elset, elset=two\n1, 2\n*Solid Section, elset=two\n*Solid Section, elset=body\n"),
             at(next + 3) && Contains("already belongs to another one"));
  CHECK_THAT(with("*End Part\n"), at(next) && Contains("without its beginning"));
  CHECK_THAT(with("*Part, name=p\n"), at(next) && Contains("nodes are defined outside of parts"));
  CHECK_THAT(fault_of("*Part, name=p\n"), Contains(":1: missing end"));
  CHECK_THAT(fault_of("*Assembly, name=a\n*Instance, name=i, part=q\n"),
             Contains(":2:") && Contains("unknown part 'q'"));
  CHECK_THAT(with("*Element, type=C3D4\n31, 1, 3, 2, 5\n"), Contains("element 31") && Contains("Jacobian"));
  CHECK_THAT(fault_of("*Node\n1, 0, 0, 0\n"), Contains("missing solid elements"));
  CHECK_THAT(fault_of(two_of_one.substr(0, two_of_one.find("*Assembly"))), Contains("missing *INSTANCE"));
  CHECK_THAT(fault_of("*KEYWORD\n*NODE\n"), Contains("unknown kind of mesh file") && Contains("Abaqus .inp"));
}
