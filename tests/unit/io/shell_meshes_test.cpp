// SPDX-License-Identifier: Apache-2.0
// Shells in foreign meshes: one quadrilateral 1 2 3 4 in the plane z = 0 and a triangle 2 5 3 beside it, with sets.
#include <exodusII.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "core/error.hpp"
#include "io/mesh/mesh_file.hpp"
#include "mesh/topology.hpp"
#include "unit/io/abaqus_text.hpp"
#include "unit/io/own_folder.hpp"

using namespace brunt;
using Catch::Contains;
using mesh::Shape;
using mesh::Side;

namespace {

using Nodes = std::vector<LocalIndex>;

mesh::Mesh read_text(const std::string& name, const std::string& text, const std::vector<std::string>& ignore = {}) {
  const test::OwnFolder folder("shells");
  const std::string path = folder.path + "/" + name;
  std::ofstream(path, std::ios::binary) << text;
  return io::read_mesh(path, ignore);
}

bool is_noted(const mesh::Mesh& mesh, const std::string& what) {
  return std::ranges::any_of(mesh.notes, [&](const auto& note) { return note.find(what) != std::string::npos; });
}

/// Side set 1 "push": the bottom of the quadrilateral and the top of the triangle; 2 "rim": edges 1-2 and 4-1.
void write_exodus(const std::string& path, const char* quads, const char* triangles) {
  int word = 8, file_word = 8;
  const int id = ex_create(path.c_str(), EX_CLOBBER, &word, &file_word);
  const std::vector<double> x{0, 1, 1, 0, 2}, y{0, 0, 1, 1, 0}, z{0, 0, 0, 0, 0};
  REQUIRE(ex_put_init(id, "shells", 3, 5, 2, 2, 0, 2) >= 0);
  ex_put_coord(id, x.data(), y.data(), z.data());
  const std::vector<int> quad{1, 2, 3, 4}, triangle{2, 5, 3};
  ex_put_block(id, EX_ELEM_BLOCK, 10, quads, 1, 4, 0, 0, 0);
  ex_put_block(id, EX_ELEM_BLOCK, 20, triangles, 1, 3, 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, 10, quad.data(), nullptr, nullptr);
  ex_put_conn(id, EX_ELEM_BLOCK, 20, triangle.data(), nullptr, nullptr);
  const std::vector<int> elements{1, 2}, sides{2, 1}, of_rim{1, 1}, edges{3, 6};
  ex_put_set_param(id, EX_SIDE_SET, 1, 2, 0);
  ex_put_set(id, EX_SIDE_SET, 1, elements.data(), sides.data());
  ex_put_name(id, EX_SIDE_SET, 1, "push");
  ex_put_set_param(id, EX_SIDE_SET, 2, 2, 0);
  ex_put_set(id, EX_SIDE_SET, 2, of_rim.data(), edges.data());
  ex_put_name(id, EX_SIDE_SET, 2, "rim");
  REQUIRE(ex_close(id) >= 0);
}

std::string gmsh(const std::string& names, int count, const std::string& elements) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" + names +
         "$EndPhysicalNames\n$Nodes\n9\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n6 0 0 1\n7 1 0 1\n8 1 1 1\n9 0 1 "
         "1\n$EndNodes\n$Elements\n" +
         std::to_string(count) + "\n" + elements + "$EndElements\n";
}

const std::string abaqus_head =
    "*Node\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 2, 0, 0\n6, 0, 0, 1\n7, 1, 0, 1\n8, 1, 1, 1\n9, 0, 1, "
    "1\n";

}  // namespace

TEST_CASE("shells of Exodus files") {
  const auto [quads, triangles] = GENERATE(std::pair{"SHELL4", "SHELL3"}, std::pair{"SHELL", "TRI3"},
                                           std::pair{"QUAD4", "TRIANGLE"}, std::pair{"quad", "trishell"});
  const test::OwnFolder folder("shells");
  write_exodus(folder.path + "/a.g", quads, triangles);
  const mesh::Mesh mesh = io::read_mesh(folder.path + "/a.g", {});
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[0].shape == Shape::quad4);
  CHECK(mesh.blocks[0].nodes == Nodes{0, 1, 2, 3});
  CHECK(mesh.blocks[1].shape == Shape::tri3);
  CHECK(mesh.blocks[1].nodes == Nodes{1, 4, 2});
  CHECK(mesh.side_sets.at("push") == std::vector<Side>{{0, 0, 1}, {1, 0, 0}});
  CHECK_FALSE(mesh.side_sets.contains("rim"));
  CHECK(mesh.node_sets.at("rim") == Nodes{0, 1, 3});
  CHECK(is_noted(mesh, "side set rim: its edges of shells are a node set"));
}

TEST_CASE("shells of Gmsh files without volumes") {
  const mesh::Mesh mesh = read_text(
      "a.msh",
      gmsh("2\n2 7 \"skin\"\n1 3 \"rim\"\n", 4, "1 3 2 7 1 1 2 3 4\n2 2 2 7 1 2 5 3\n3 1 2 3 1 1 2\n4 1 2 3 1 2 5\n"));
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[0].name == "skin");
  CHECK(mesh.blocks[0].id == 7);
  CHECK(mesh.blocks[0].nodes == Nodes{0, 1, 2, 3});
  CHECK(mesh.blocks[1].name == "skin_tri3");
  CHECK(mesh.blocks[1].nodes == Nodes{1, 4, 2});
  CHECK(mesh.side_sets.at("skin") == std::vector<Side>{{0, 0, 0}, {1, 0, 0}});
  CHECK(mesh.node_sets.at("rim") == Nodes{0, 1, 4});

  const mesh::Mesh bare = read_text("a.msh", gmsh("0\n", 2, "1 3 2 0 4 1 2 3 4\n2 2 2 0 5 2 5 3\n"));
  REQUIRE(bare.blocks.size() == 2);
  CHECK(bare.blocks[0].name == "surface_4");
  CHECK(bare.blocks[1].name == "surface_5");
}

TEST_CASE("a surface of a Gmsh file is shells or faces of volumes, not both") {
  const std::string names = "3\n3 1 \"body\"\n2 1 \"foot\"\n2 7 \"fin\"\n", cube = "1 5 2 1 1 1 2 3 4 6 7 8 9\n";
  const mesh::Mesh mesh = read_text("a.msh", gmsh(names, 3, cube + "2 3 2 1 1 1 2 3 4\n3 2 2 7 2 2 5 3\n"));
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[0].shape == Shape::hex8);
  CHECK(mesh.blocks[1].name == "fin");
  CHECK(mesh.blocks[1].shape == Shape::tri3);
  CHECK(mesh.side_sets.at("foot") == std::vector<Side>{{0, 0, 4}});
  CHECK(mesh.side_sets.at("fin") == std::vector<Side>{{1, 0, 0}});
  CHECK_THROWS_WITH(read_text("a.msh", gmsh(names, 3, cube + "2 3 2 7 1 1 2 3 4\n3 2 2 7 2 2 5 3\n")),
                    Contains("invalid surface element 3: not a face of a volume element"));
  CHECK(read_text("a.msh", gmsh(names, 3, cube + "2 3 2 1 1 1 2 3 4\n3 2 2 7 2 2 5 3\n"), {"fin"}).blocks.size() == 1);
}

TEST_CASE("shells of Abaqus files") {
  const auto [quads, triangles] =
      GENERATE(std::pair{"S4R", "S3R"}, std::pair{"S4", "S3"}, std::pair{"S4RS", "STRI3"}, std::pair{"s4r5", "s3rs"});
  const mesh::Mesh mesh =
      test::read(abaqus_head + "*Element, type=" + quads + ", elset=skin\n1, 1, 2, 3, 4\n*Element, type=" + triangles +
                 ", elset=skin\n2, 2, 5, 3\n*Shell Section, elset=skin, material=m\n0.1, 5\n*Surface, name=push\nskin, "
                 "SNEG\n*Surface, name=up\n1, SPOS\n2,\n");
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[0].name == "skin");
  CHECK(mesh.blocks[0].shape == Shape::quad4);
  CHECK(mesh.blocks[0].nodes == Nodes{0, 1, 2, 3});
  CHECK(mesh.blocks[1].name == "skin_tri3");
  CHECK(mesh.blocks[1].nodes == Nodes{1, 4, 2});
  CHECK(mesh.side_sets.at("push") == std::vector<Side>{{0, 0, 1}, {1, 0, 1}});
  CHECK(mesh.side_sets.at("up") == std::vector<Side>{{0, 0, 0}, {1, 0, 0}});
  CHECK(is_noted(mesh, "the key thickness of the part"));
}

TEST_CASE("solids and shells of one Abaqus file, and what is refused") {
  const std::string cube = "*Element, type=C3D8, elset=body\n1, 1, 2, 3, 4, 6, 7, 8, 9\n",
                    fin = "*Element, type=S3, elset=fin\n2, 2, 5, 3\n";
  const mesh::Mesh mesh = test::read(abaqus_head + cube + fin);
  REQUIRE(mesh.blocks.size() == 2);
  CHECK(mesh.blocks[1].name == "fin");
  CHECK(mesh.blocks[1].shape == Shape::tri3);
  CHECK_THAT(test::fault_of(abaqus_head + cube + fin + "*Surface, name=s\nfin, E1\n"),
             Contains("it is a shell, and only its two sides are read; expected SPOS or SNEG"));
  CHECK_THAT(test::fault_of(abaqus_head + cube + fin + "*Surface, name=s\nbody, SPOS\n"), Contains("is a solid"));
  CHECK_THAT(test::fault_of(abaqus_head + "*Element, type=STRI65, elset=fin\n2, 1, 2, 3, 4, 5, 6\n"),
             Contains("invalid element type STRI65, a shell of second order"));
  CHECK(test::fault_of(abaqus_head + cube + fin + "*Solid Section, elset=body\n") == "none");
  CHECK_THAT(test::fault_of(abaqus_head + cube + fin +
                            "*Element, type=S3, elset=more\n3, 1, 2, 6\n*Shell Section, elset=fin\n"),
             Contains("missing *SHELL SECTION for element 3; expected a section for each shell"));
}
