// SPDX-License-Identifier: Apache-2.0
// Small Gmsh files, both versions, and what is refused with its line.
#include "io/mesh/gmsh.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "io/mesh/mesh_file.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using mesh::Side;

namespace {

struct TemporaryFile {
  std::string path =
      (std::filesystem::temp_directory_path() / ("brunt_gmsh_" + std::to_string(getpid()) + ".msh")).string();
  ~TemporaryFile() { std::filesystem::remove(path); }
  void put(const std::string& text) const { std::ofstream(path) << text; }
};

/// A cube, a prism on its face x = 1, and a tetrahedron of the same volume group apart.
const std::string version_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 5 "foot"
3 1 "body of steel"
$EndPhysicalNames
$Nodes
14
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
9 2 0 0
10 2 0 1
21 5 0 0
22 6 0 0
23 5 1 0
24 5 0 1
$EndNodes
$Elements
7
1 15 2 0 1 1
2 1 2 0 1 1 2
3 3 2 5 1 1 4 3 2
4 2 2 6 2 2 3 9
5 5 2 1 1 1 2 3 4 5 6 7 8
6 6 2 1 1 2 9 3 6 10 7
7 4 2 1 1 21 22 23 24
$EndElements
)";

const std::string version_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 5 "foot"
$EndPhysicalNames
$Entities
1 0 1 2
1 0 0 0 0
3 0 0 0 1 1 0 2 5 6 0
1 0 0 0 1 1 1 1 40 0
2 0 0 1 1 1 2 0 0
$EndEntities
$Nodes
2 12 1 12
2 3 0 4
1
2
3
4
0 0 0
1 0 0
1 1 0
0 1 0
3 1 0 8
5
6
7
8
9
10
11
12
0 0 1
1 0 1
1 1 1
0 1 1
0 0 2
1 0 2
1 1 2
0 1 2
$EndNodes
$Elements
3 3 1 3
2 3 3 1
1 1 4 3 2
3 1 5 1
2 1 2 3 4 5 6 7 8
3 2 5 1
3 5 6 7 8 9 10 11 12
$EndElements
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

/// The fault without the path, so "LINE: what".
std::string fault_of(const std::string& text) {
  const TemporaryFile file;
  file.put(text);
  try {
    io::read_mesh(file.path);
  } catch (const InputError& error) {
    REQUIRE(error.faults().size() == 1);
    REQUIRE(error.faults()[0].find(file.path + ":") == 0);
    return error.faults()[0].substr(file.path.size() + 1);
  }
  return "none";
}

}  // namespace

TEST_CASE("version 2.2: groups become blocks and sets", "[gmsh]") {
  const TemporaryFile file;
  file.put(version_2);
  const mesh::Mesh mesh = io::read_mesh(file.path);
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[0].name == "body of steel");
  CHECK(mesh.blocks[0].id == 1);
  CHECK(mesh.blocks[0].element_id == std::vector<GlobalIndex>{5, 6});
  CHECK(std::vector(mesh.blocks[0].element(1), mesh.blocks[0].element(1) + 8) ==
        std::vector<LocalIndex>{1, 8, 2, 2, 5, 9, 6, 6});
  CHECK(mesh.blocks[1].name == "body of steel_tet4");
  CHECK(mesh.blocks[1].id == 2);
  CHECK(mesh.blocks[1].nodes == std::vector<LocalIndex>{10, 11, 12, 13});
  CHECK(mesh.node_id[10] == 21);
  CHECK(mesh.side_sets.at("foot") == std::vector<Side>{{0, 0, 4}});
  CHECK(mesh.side_sets.at("6") == std::vector<Side>{{0, 1, 4}});  // the prism's triangle
  CHECK(mesh.node_sets.at("foot") == std::vector<LocalIndex>{0, 1, 2, 3});
  CHECK(mesh.node_sets.at("6") == std::vector<LocalIndex>{1, 2, 8});
  CHECK(mesh::exterior_sides(mesh).size() == 6 + 5 - 2 + 4);
}

TEST_CASE("version 4.1: entities carry the groups", "[gmsh]") {
  const TemporaryFile file;
  file.put(version_4);
  const mesh::Mesh mesh = io::read_gmsh(file.path);
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[0].name.empty());
  CHECK(mesh.blocks[0].id == 40);
  CHECK(mesh.blocks[1].name == "volume_2");
  CHECK(mesh.blocks[1].id == 41);
  CHECK(mesh.coordinates[4] == Vec3(0, 0, 1));
  CHECK(mesh.side_sets.at("foot") == std::vector<Side>{{0, 0, 4}});
  CHECK(mesh.side_sets.at("6") == mesh.side_sets.at("foot"));  // one surface in two groups
  CHECK(mesh::exterior_sides(mesh).size() == 10);
}

TEST_CASE("an inner surface belongs to the element that its normal points out of", "[gmsh]") {
  const TemporaryFile file;
  file.put(replaced(version_4, "1 1 4 3 2", "1 5 6 7 8"));
  CHECK(io::read_gmsh(file.path).side_sets.at("foot") == std::vector<Side>{{0, 0, 5}});
  file.put(replaced(version_4, "1 1 4 3 2", "1 6 5 8 7"));
  CHECK(io::read_gmsh(file.path).side_sets.at("foot") == std::vector<Side>{{1, 0, 4}});
}

TEST_CASE("what cannot be used is refused with its line", "[gmsh]") {
  CHECK(fault_of(replaced(version_2, "2.2 0 8", "3.0 0 8")).find("2: unknown MSH version 3; expected 2.2 or 4.1") == 0);
  CHECK(fault_of(replaced(version_4, "4.1 0 8", "4.1 1 8")).find("2: invalid binary MSH file; expected") == 0);
  CHECK(fault_of(replaced(version_2, "7 4 2 1 1 21", "7 11 2 1 1 21")).find("34: invalid element type 11") == 0);
  CHECK(fault_of(replaced(version_2, "21 22 23 24\n", "21 22 23 25\n")) ==
        "34: invalid element 7: unknown node 25; expected nodes defined in $Nodes");
  CHECK(fault_of(replaced(version_2, "21 22 23 24\n", "21 22 23\n")) ==
        "34: missing value at the end of the line; expected a node number");
  CHECK(fault_of(replaced(version_2, "21 22 23 24\n", "21 22 23 24 1\n")) ==
        "34: invalid line: too many nodes; expected 4 for this element type");
  CHECK(fault_of(replaced(version_2, "24 5 0 1", "24 5 0 1x")) == "24: invalid value '1x'; expected a coordinate");
  CHECK(fault_of(replaced(version_2, "24 5 0 1", "23 5 0 1")) ==
        "24: invalid node 23: defined twice; expected each node once");
  CHECK(fault_of(replaced(version_2, "\n14\n", "\n13\n")).find("24: invalid text '24 5 0 1'; expected $EndNodes") == 0);
  CHECK(fault_of(replaced(version_2, "\n14\n", "\n140000000000\n")).find("10: out of range: the number of nodes is") ==
        0);
  CHECK(fault_of(replaced(version_2, "1 4 3 2", "1 4 3 9")) == "none");  // shells, see shell_meshes_test.cpp
  CHECK(fault_of(replaced(version_4, "1 1 40 0", "1 2 40 41 0")) ==
        "12: invalid volume 1: it belongs to 2 physical groups; expected one");
  CHECK(fault_of(replaced(version_4, "2 12 1 12", "2 13 1 13")).find("12 in the blocks; expected 13") !=
        std::string::npos);
  CHECK(fault_of(replaced(version_2, "21 22 23 24\n", "21 23 22 24\n"))
            .find(" invalid element 7 (block body of steel_tet4): the Jacobian") == 0);
  CHECK(fault_of(replaced(version_2, "24 5 0 1", "24 5 0 nan")).find(" invalid node 24: coordinates") == 0);
}

TEST_CASE("a group whose name is the number of another one stays apart", "[gmsh]") {
  const TemporaryFile file;
  file.put(replaced(version_2, "\"foot\"", "\"6\""));  // group 6 has no name
  const mesh::Mesh mesh = io::read_mesh(file.path);
  CHECK(mesh.side_sets.at("6") == std::vector<Side>{{0, 0, 4}});
  CHECK(mesh.node_sets.at("6") == std::vector<LocalIndex>{0, 1, 2, 3});
  CHECK(mesh.side_sets.at("number_6") == std::vector<Side>{{0, 1, 4}});
  CHECK(mesh.node_sets.at("number_6") == std::vector<LocalIndex>{1, 2, 8});
  REQUIRE(mesh.notes.size() == 1);
  CHECK(mesh.notes[0] ==
        "physical surface 6: another physical surface has the name '6': this one is called 'number_6' here");
  const std::string twice =
      replaced(replaced(version_2, "Names\n2\n", "Names\n3\n"), "3 1 \"body", "2 6 \"foot\"\n3 1 \"body");
  file.put(twice);
  const mesh::Mesh two = io::read_mesh(file.path);
  CHECK(two.side_sets.at("foot") == std::vector<Side>{{0, 0, 4}});
  CHECK(two.side_sets.at("6") == std::vector<Side>{{0, 1, 4}});
  REQUIRE(two.notes.size() == 1);
  CHECK_THAT(two.notes[0], Catch::StartsWith("physical surface 6: another physical surface has the name 'foot'"));
}

TEST_CASE("two elements of one number are refused, one surface element in two groups is not", "[gmsh]") {
  CHECK(fault_of(replaced(version_2, "6 6 2 1 1", "5 6 2 1 1")) ==
        "33: invalid element 5: another element has this number (line 32); expected a number of its own for each "
        "element");
  CHECK_THAT(fault_of(replaced(version_2, "7 4 2 1 1", "5 4 2 1 1")),
             Catch::StartsWith("34: invalid element 5: another"));
  CHECK_THAT(fault_of(replaced(version_4, "3 5 6 7 8 9", "2 5 6 7 8 9")),
             Catch::StartsWith("51: invalid element 2: another"));
  const TemporaryFile file;
  file.put(
      replaced(replaced(version_2, "Elements\n7\n", "Elements\n8\n"), "4 2 2 6 2", "3 3 2 9 1 1 4 3 2\n4 2 2 6 2"));
  const mesh::Mesh mesh = io::read_mesh(file.path);
  CHECK(mesh.side_sets.at("9") == mesh.side_sets.at("foot"));
  file.put(
      replaced(replaced(version_2, "Elements\n7\n", "Elements\n8\n"), "4 2 2 6 2", "9 3 2 5 1 1 4 3 2\n4 2 2 6 2"));
  CHECK(io::read_mesh(file.path).side_sets.at("foot").size() == 1);  // a face that is listed twice is one face
}

TEST_CASE("a Gmsh file cut off anywhere is refused", "[gmsh]") {
  for (const std::string& text : {version_2, version_4})
    for (std::size_t length = 15; length < text.size() - 1; ++length) {
      INFO("cut to " << length << " of " << text.size() << " bytes");
      REQUIRE(fault_of(text.substr(0, length)) != "none");
    }
}
