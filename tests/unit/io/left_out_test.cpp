// SPDX-License-Identifier: Apache-2.0
// Foreign meshes with blocks that are not read: left out by name or number, with what sets lose, or a fault that says
// so.
#include <exodusII.h>
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "io/mesh/mesh_file.hpp"
#include "unit/io/own_folder.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

std::string cube_nodes(int first, double x, bool comma) {
  std::string text;
  const char* const format = comma ? "{}, {}, {}, {}\n" : "{} {} {} {}\n";
  for (int z = 0; z < 2; ++z)
    for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      text += fmt::format(fmt::runtime(format), first++, x + a, b, z);
  return text;
}

/// Two cubes "one" and "two", a shell of second order on two free nodes and two of the first cube, a point mass,
/// trusses and a quadratic element; sets that reach into all of them.
std::string abaqus() {
  return "*Node\n" + cube_nodes(1, 0, true) + cube_nodes(11, 2, true) + "21, 0, 0, 5\n22, 1, 0, 5\n" +
         "*Element, type=C3D8, elset=one\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
         "*Element, type=C3D8R, elset=two\n2, 11, 12, 13, 14, 15, 16, 17, 18\n"
         "*Element, type=S8R\n3, 5, 6, 22, 21\n"
         "*Elset, elset=skin\n3\n"
         "*Element, type=MASS, elset=ball\n4, 21\n"
         "*Element, type=T3D2, elset=rods\n5, 21, 22\n"
         "*Element, type=C3D10, elset=fine\n6, 1, 2, 3, 4, 5, 6, 7,\n8, 11, 12\n"
         "*Nset, nset=ends\n1, 11, 21\n*Nset, nset=far\n21, 22\n"
         "*Surface, name=sides\none, S1\ntwo, S2\nskin, SPOS\n"
         "*Shell Section, elset=skin, material=m\n0.1,\n";
}

/// The same in Gmsh 2.2: volumes 1 "one" and 2 "two", a quadratic shell 7 "skin", a quadratic volume 3.
std::string gmsh() {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n3 1 \"one\"\n3 2 \"two\"\n2 7 \"skin\"\n2 8 "
         "\"sides\"\n1 "
         "9 \"edge\"\n$EndPhysicalNames\n$Nodes\n18\n" +
         cube_nodes(1, 0, false) + cube_nodes(11, 2, false) + "21 0 0 5\n22 1 0 5\n$EndNodes\n$Elements\n7\n" +
         "1 5 2 1 1 1 2 3 4 5 6 7 8\n2 5 2 2 2 11 12 13 14 15 16 17 18\n3 10 2 7 3 5 6 22 21\n"
         "4 3 2 8 4 1 4 3 2\n5 3 2 8 5 15 16 17 18\n6 1 2 9 1 21 22\n7 11 2 3 3 1 2 3 4 5 6 7 8 11 12\n$EndElements\n";
}

/// The same in Exodus: blocks 10 "one", 20 "two", 30 "skin" of MEMBRANE4, 40 of one-node SPHERE between them.
void write_exodus(const std::string& path) {
  int word = 8, file_word = 8;
  const int id = ex_create(path.c_str(), EX_CLOBBER, &word, &file_word);
  std::vector<double> x, y, z;
  for (const double at : {0.0, 2.0})
    for (const double height : {0.0, 1.0})
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        x.push_back(at + a);
        y.push_back(b);
        z.push_back(height);
      }
  for (const double at : {0.0, 1.0}) {
    x.push_back(at);
    y.push_back(0);
    z.push_back(5);
  }
  REQUIRE(ex_put_init(id, "mixed", 3, 18, 5, 4, 1, 1) >= 0);
  ex_put_coord(id, x.data(), y.data(), z.data());
  const std::vector<int> one{1, 2, 3, 4, 5, 6, 7, 8}, two{9, 10, 11, 12, 13, 14, 15, 16}, skin{5, 6, 18, 17},
      balls{17, 18};
  const auto put = [&](int block, const char* type, int count, int nodes, const std::vector<int>& corners,
                       const char* name) {
    ex_put_block(id, EX_ELEM_BLOCK, block, type, count, nodes, 0, 0, 0);
    ex_put_conn(id, EX_ELEM_BLOCK, block, corners.data(), nullptr, nullptr);
    if (*name != '\0') ex_put_name(id, EX_ELEM_BLOCK, block, name);
  };
  put(10, "HEX8", 1, 8, one, "one");
  put(30, "MEMBRANE4", 1, 4, skin, "skin");
  put(40, "SPHERE", 2, 1, balls, "");
  put(20, "HEX8", 1, 8, two, "two");
  const std::vector<int> ends{1, 9, 17}, elements{1, 2, 5}, sides{5, 1, 6}, numbers{101, 102, 103, 104, 105};
  ex_put_id_map(id, EX_ELEM_MAP, numbers.data());
  ex_put_set_param(id, EX_NODE_SET, 1, 3, 0);
  ex_put_set(id, EX_NODE_SET, 1, ends.data(), nullptr);
  ex_put_name(id, EX_NODE_SET, 1, "ends");
  ex_put_set_param(id, EX_SIDE_SET, 1, 3, 0);
  ex_put_set(id, EX_SIDE_SET, 1, elements.data(), sides.data());
  ex_put_name(id, EX_SIDE_SET, 1, "sides");
  REQUIRE(ex_close(id) >= 0);
}

struct File {
  test::OwnFolder folder{"left_out"};
  std::string path;
  explicit File(const std::string& text) : path(folder.path + "/mesh") { std::ofstream(path) << text; }
  File() : path(folder.path + "/mesh") { write_exodus(path); }
};

std::vector<std::string> faults_of(const std::string& path, const std::vector<std::string>& ignore) {
  try {
    io::read_mesh(path, ignore);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

bool says(const std::vector<std::string>& lines, const std::string& what) {
  return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(what) != std::string::npos; });
}

}  // namespace

TEST_CASE("a block that is not read is a fault that names the remedy", "[left_out]") {
  const File inp(abaqus()), msh(gmsh()), exo;
  const auto of_inp = faults_of(inp.path, {}), of_msh = faults_of(msh.path, {}), of_exo = faults_of(exo.path, {});
  CHECK(of_inp.size() == 3);
  for (const char* name : {"skin", "ball", "fine"}) CHECK(says(of_inp, fmt::format("ignore: [{}]", name)));
  CHECK(says(of_inp, "mesh:24: invalid element type S8R, a shell of second order"));
  CHECK(of_msh.size() == 2);
  CHECK(says(of_msh, "invalid element type 10"));
  CHECK(says(of_msh, "ignore: [skin]"));
  CHECK(says(of_msh, "ignore: [3]"));
  CHECK(of_exo.size() == 2);
  CHECK(says(of_exo, "invalid block 30 (skin): elements MEMBRANE4 with 4 nodes"));
  CHECK(says(of_exo, "ignore: [40]"));
  CHECK(faults_of(exo.path, {"skin"}).size() == 1);
}

TEST_CASE("what is ignored vanishes with its nodes, sets keep the rest", "[left_out]") {
  const File inp(abaqus()), msh(gmsh()), exo;
  struct Known {
    std::string path;
    std::vector<std::string> ignore;
    std::size_t left_out;
  };
  for (const auto& [path, ignore, left_out] :
       {Known{inp.path, {"skin", "ball", "fine"}, 4}, Known{msh.path, {"skin", "3"}, 2},
        Known{exo.path, {"30", "40"}, 2}, Known{exo.path, {"skin", "40"}, 2}, Known{msh.path, {"3", "edge", "7"}, 2}}) {
    INFO(path << ' ' << ignore[0]);
    const mesh::Mesh mesh = io::read_mesh(path, ignore);
    REQUIRE(mesh.blocks.size() == 2);
    CHECK(mesh.blocks[1].name == "two");
    CHECK(mesh.coordinates.size() == 16);
    CHECK(mesh.left_out.size() == left_out);
    CHECK(mesh.side_sets.at("sides").size() == 2);
    CHECK(mesh.side_sets.at("sides")[1].block == 1);
    CHECK_FALSE(mesh.side_sets.contains("skin"));
    if (path == msh.path) continue;
    CHECK(mesh.node_sets.at("ends").size() == 2);
    CHECK(says(mesh.notes, "node set ends: 1 of its 3 nodes"));
    CHECK(says(mesh.notes, "side set sides: 1 of its 3 sides"));
  }
  const mesh::Mesh mesh = io::read_mesh(inp.path, {"ball", "fine", "skin"});
  CHECK(mesh.node_sets.at("far").empty());
  CHECK(says(mesh.notes, "node set far: 2 of its 2 nodes"));
}

TEST_CASE("a block that could be read may be ignored as well", "[left_out]") {
  const File inp(abaqus()), msh(gmsh()), exo;
  for (const auto& [path, ignore] :
       {std::pair<std::string, std::vector<std::string>>{inp.path, {"skin", "ball", "fine", "one"}},
        {msh.path, {"skin", "3", "one"}},
        {msh.path, {"skin", "3", "1"}},
        {exo.path, {"30", "40", "10"}}}) {
    const mesh::Mesh mesh = io::read_mesh(path, ignore);
    REQUIRE(mesh.blocks.size() == 1);
    CHECK(mesh.blocks[0].name == "two");
    CHECK(mesh.coordinates.size() == 8);
    CHECK(mesh.side_sets.at("sides").size() == 1);
    CHECK(mesh.side_sets.at("sides")[0].block == 0);
    CHECK(says(mesh.notes, "side set sides: "));
  }
  CHECK(says(faults_of(exo.path, {"10", "20", "30", "40"}), "it excludes every block"));
}

TEST_CASE("a name to ignore that the file does not have is a fault", "[left_out]") {
  const File inp(abaqus()), msh(gmsh()), exo;
  for (const std::string& path : {inp.path, msh.path, exo.path})
    for (const std::string name : {"sknn", "77", "-1", "0"}) {
      const auto faults = faults_of(path, {name});
      CHECK(says(faults, fmt::format("unknown block '{}' in ignore", name)));
      CHECK(says(faults, "; expected "));
    }
}
