// SPDX-License-Identifier: Apache-2.0
// Exodus meshes written by the library itself, then read, cut off, damaged.
#include "io/mesh/exodus.hpp"

#include <exodusII.h>
#include <netcdf.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/error.hpp"
#include "io/mesh/mesh_file.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using mesh::Side;

namespace {

/// A file of its own for each test process, gone with the test.
struct TemporaryFile {
  std::string path =
      (std::filesystem::temp_directory_path() / ("brunt_exodus_" + std::to_string(getpid()) + ".g")).string();
  ~TemporaryFile() { std::filesystem::remove(path); }
};

struct Options {
  std::string first_type = "HEX8";
  int dimensions = 3;
  int bad_corner = 0;                                 ///< if not 0: the last node of the tetrahedron
  int bad_side = 0;                                   ///< if not 0: the wedge's side
  std::string foot = "foot", tip{}, wedge = "wedge";  ///< names of node sets 1 and 2, and of side set 8
};

/// A unit cube, on it (z > 1) a wedge, beside the wedge's slope nothing, and a tetrahedron apart.
///   block 10 "cube": nodes 1-8; block 20, unnamed: wedge 5 6 7 | 9 10 11 above the cube; block 30 "tip": 12-15
void write(const std::string& path, const Options& options = {}) {
  int word = 8, file_word = 8;
  const int id = ex_create(path.c_str(), EX_CLOBBER, &word, &file_word);
  REQUIRE(id > 0);
  std::vector<double> x{0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 5, 6, 5, 5};
  std::vector<double> y{0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0};
  std::vector<double> z{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 0, 0, 0, 1};
  REQUIRE(ex_put_init(id, "small", options.dimensions, 15, 3, 3, 2, 2) >= 0);
  ex_put_coord(id, x.data(), y.data(), z.data());
  const std::vector<int> hex{1, 2, 3, 4, 5, 6, 7, 8}, wedge{5, 6, 7, 9, 10, 11};
  const std::vector<int> tet{12, 13, 14, options.bad_corner == 0 ? 15 : options.bad_corner};
  ex_put_block(id, EX_ELEM_BLOCK, 10, options.first_type.c_str(), 1, 8, 0, 0, 0);
  ex_put_block(id, EX_ELEM_BLOCK, 20, "WEDGE", 1, 6, 0, 0, 0);
  ex_put_block(id, EX_ELEM_BLOCK, 30, "tetra", 1, 4, 0, 0, 0);
  ex_put_conn(id, EX_ELEM_BLOCK, 10, hex.data(), nullptr, nullptr);
  ex_put_conn(id, EX_ELEM_BLOCK, 20, wedge.data(), nullptr, nullptr);
  ex_put_conn(id, EX_ELEM_BLOCK, 30, tet.data(), nullptr, nullptr);
  ex_put_name(id, EX_ELEM_BLOCK, 10, "cube");
  ex_put_name(id, EX_ELEM_BLOCK, 30, "tip");
  const std::vector<int> numbers{101, 102, 103};
  ex_put_id_map(id, EX_ELEM_MAP, numbers.data());
  const std::vector<int> foot{1, 2, 3, 4}, one{15};
  ex_put_set_param(id, EX_NODE_SET, 1, 4, 0);
  ex_put_set(id, EX_NODE_SET, 1, foot.data(), nullptr);
  ex_put_set_param(id, EX_NODE_SET, 2, 1, 0);
  ex_put_set(id, EX_NODE_SET, 2, one.data(), nullptr);
  ex_put_name(id, EX_NODE_SET, 1, options.foot.c_str());
  ex_put_name(id, EX_NODE_SET, 2, options.tip.c_str());
  const std::vector<int> hex_and_tet{1, 3}, their_sides{5, 4};
  ex_put_set_param(id, EX_SIDE_SET, 7, 2, 0);
  ex_put_set(id, EX_SIDE_SET, 7, hex_and_tet.data(), their_sides.data());
  const std::vector<int> wedges(5, 2), all_sides{1, 2, 3, 4, options.bad_side == 0 ? 5 : options.bad_side};
  ex_put_set_param(id, EX_SIDE_SET, 8, 5, 0);
  ex_put_set(id, EX_SIDE_SET, 8, wedges.data(), all_sides.data());
  ex_put_name(id, EX_SIDE_SET, 8, options.wedge.c_str());
  REQUIRE(ex_close(id) >= 0);
}

std::string fault_of(const std::string& path) {
  try {
    io::read_mesh(path);
  } catch (const InputError& error) {
    REQUIRE(error.faults().size() == 1);
    return error.faults()[0];
  }
  return "none";
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put_bytes(const std::string& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

TEST_CASE("blocks, names, numbers and sets are read", "[exodus]") {
  const TemporaryFile file;
  write(file.path);
  const mesh::Mesh mesh = io::read_mesh(file.path);
  REQUIRE(mesh.blocks.size() == 3);
  CHECK(mesh.blocks[0].name == "cube");
  CHECK(mesh.blocks[1].name.empty());
  CHECK(mesh.blocks[1].id == 20);
  CHECK(mesh.blocks[1].nodes == std::vector<LocalIndex>{4, 5, 6, 6, 8, 9, 10, 10});
  CHECK(mesh.blocks[2].shape == mesh::Shape::tet4);
  CHECK(mesh.blocks[2].element_id == std::vector<GlobalIndex>{103});
  CHECK(mesh.coordinates[10] == Vec3(1, 1, 2));
  CHECK(mesh.node_id[14] == 15);
  CHECK(mesh.node_sets.at("foot") == std::vector<LocalIndex>{0, 1, 2, 3});
  CHECK(mesh.node_sets.at("2") == std::vector<LocalIndex>{14});
  CHECK(mesh.side_sets.at("7") == std::vector<Side>{{0, 0, 4}, {2, 0, 3}});
}

TEST_CASE("a set whose name is the number of another one stays apart", "[exodus]") {
  const TemporaryFile file;
  const std::vector<LocalIndex> foot{0, 1, 2, 3}, tip{14};
  write(file.path, {.foot = "2", .wedge = "7"});  // node set 2 and side set 7 have no names
  const mesh::Mesh mesh = io::read_mesh(file.path);
  CHECK(mesh.node_sets.at("2") == foot);
  CHECK(mesh.node_sets.at("number_2") == tip);
  CHECK(mesh.side_sets.at("7").size() == 5);
  CHECK(mesh.side_sets.at("number_7").size() == 2);
  REQUIRE(mesh.notes.size() == 2);
  CHECK(mesh.notes[0] == "node set 2: another node set has the name '2': this one is called 'number_2' here");
  write(file.path, {.tip = "foot"});
  const mesh::Mesh twice = io::read_mesh(file.path);
  CHECK(twice.node_sets.at("foot") == foot);
  CHECK(twice.node_sets.at("2") == tip);
  REQUIRE(twice.notes.size() == 1);
  CHECK(twice.notes[0] == "node set 2: another node set has the name 'foot': this one is called '2' here");
}

TEST_CASE("a wedge's sides have the nodes that the format's manual gives them", "[exodus]") {
  const TemporaryFile file;
  write(file.path);
  const mesh::Mesh mesh = io::read_exodus(file.path);
  // sides 1-5 of the wedge (1 2 3 | 4 5 6): 1254, 2365, 1463, 132, 456; here 1-6 are nodes 4 5 6 8 9 10
  const std::vector<std::array<LocalIndex, 4>> expected{
      {4, 5, 9, 8}, {5, 6, 10, 9}, {4, 8, 10, 6}, {4, 6, 5, no_index}, {8, 9, 10, no_index}};
  const auto& sides = mesh.side_sets.at("wedge");
  REQUIRE(sides.size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(mesh::face_nodes(mesh::Shape::hex8, mesh.blocks[1].element(sides[i].element), sides[i].face) == expected[i]);
}

TEST_CASE("coordinates are read wherever they stand in the file", "[exodus]") {
  const TemporaryFile file;
  for (std::size_t first = 0; first < 3; ++first) {
    int id = 0, nodes = 0, elements = 0, blocks = 0, corner = 0, other = 0, connect = 0, number = 0;
    REQUIRE(nc_create(file.path.c_str(), NC_CLOBBER, &id) == NC_NOERR);
    const float version = 5.1F;
    const int word = 8, one = 1;
    nc_put_att_float(id, NC_GLOBAL, "api_version", NC_FLOAT, 1, &version);
    nc_put_att_float(id, NC_GLOBAL, "version", NC_FLOAT, 1, &version);
    nc_put_att_int(id, NC_GLOBAL, "floating_point_word_size", NC_INT, 1, &word);
    nc_put_att_text(id, NC_GLOBAL, "title", 4, "cube");
    nc_put_att_int(id, NC_GLOBAL, "file_size", NC_INT, 1, &one);  // an array for each axis
    nc_def_dim(id, "num_dim", 3, &other);
    nc_def_dim(id, "num_nodes", 8, &nodes);
    nc_def_dim(id, "num_elem", 1, &elements);
    nc_def_dim(id, "num_el_blk", 1, &blocks);
    nc_def_dim(id, "num_el_in_blk1", 1, &elements);
    nc_def_dim(id, "num_nod_per_el1", 8, &corner);
    std::array<int, 3> axes{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t axis = (first + k) % 3;
      nc_def_var(id, (std::string("coord") + "xyz"[axis]).c_str(), NC_DOUBLE, 1, &nodes, &axes[axis]);
    }
    const std::array<int, 2> table{elements, corner};
    nc_def_var(id, "eb_prop1", NC_INT, 1, &blocks, &number);
    nc_put_att_text(id, number, "name", 2, "ID");
    nc_def_var(id, "connect1", NC_INT, 2, table.data(), &connect);
    nc_put_att_text(id, connect, "elem_type", 4, "HEX8");
    nc_enddef(id);
    const std::array<int, 8> cube{1, 2, 3, 4, 5, 6, 7, 8};
    nc_put_var_int(id, number, &one);
    nc_put_var_int(id, connect, cube.data());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<double, 8> values{};
      for (std::size_t n = 0; n < 8; ++n) {
        const std::array<bool, 3> at_one{n % 4 == 1 || n % 4 == 2, n % 4 > 1, n > 3};
        values[n] = at_one[axis] ? 1 : 0;
      }
      nc_put_var_double(id, axes[axis], values.data());
    }
    REQUIRE(nc_close(id) == NC_NOERR);
    const mesh::Mesh mesh = io::read_mesh(file.path);
    CHECK(mesh.coordinates[6] == Vec3(1, 1, 1));
    CHECK(mesh.coordinates[1] == Vec3(1, 0, 0));
    CHECK(mesh.coordinates[4] == Vec3(0, 0, 1));
  }
}

TEST_CASE("an Exodus mesh that cannot be used is refused by name", "[exodus]") {
  const TemporaryFile file;
  write(file.path, {.first_type = "SHELL8"});
  CHECK(fault_of(file.path) ==
        file.path +
            ": invalid block 10 (cube): elements SHELL8 with 8 nodes; expected HEX8, TET4, "
            "WEDGE6, PYRAMID5, SHELL4 or SHELL3, or ignore: [cube] beside file to exclude the block");
  write(file.path, {.dimensions = 2});
  CHECK(fault_of(file.path) == file.path + ": invalid number of dimensions, 2; expected 3");
  write(file.path, {.bad_corner = 16});
  CHECK(fault_of(file.path) ==
        file.path + ": invalid element 103 (block tip): corner 4 refers to node position 16; expected 1 to 15");
  write(file.path, {.bad_side = 6});
  CHECK(fault_of(file.path).find(": invalid side set wedge: unknown side") != std::string::npos);
  CHECK(fault_of("/no/such/mesh.g").find("/no/such/mesh.g: cannot read the mesh file") == 0);
}

TEST_CASE("an Exodus file cut off anywhere is refused", "[exodus]") {
  const TemporaryFile file;
  write(file.path);
  const std::string whole = bytes_of(file.path);
  for (std::size_t length = 4; length < whole.size() - 4; length += 13) {
    put_bytes(file.path, std::string_view(whole).substr(0, length));
    INFO("cut to " << length << " of " << whole.size() << " bytes");
    REQUIRE(fault_of(file.path) != "none");
  }
}

TEST_CASE("a damaged file gives a fault or a sound mesh, never a crash", "[exodus]") {
  const TemporaryFile file;
  write(file.path);
  const std::string whole = bytes_of(file.path);
  std::mt19937 random(11);
  int refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string damaged = whole;
    auto& byte = damaged[random() % damaged.size()];
    byte = static_cast<char>(byte ^ (1 << (random() % 8)));
    put_bytes(file.path, damaged);
    try {
      io::read_exodus(file.path);
    } catch (const InputError& error) {
      ++refused;
      CHECK(std::string(error.what()).find(file.path) == 0);
    }
  }
  CHECK(refused > 30);
}
