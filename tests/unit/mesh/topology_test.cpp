// SPDX-License-Identifier: Apache-2.0
// Faces of full and degenerate elements, the outside of small meshes, connected bodies.
#include "mesh/topology.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::mesh;

namespace {

using Face = std::array<LocalIndex, 4>;

Mesh mesh_of(LocalIndex nodes, std::vector<Block> blocks) {
  Mesh mesh;
  mesh.coordinates.assign(static_cast<std::size_t>(nodes), Vec3::Zero());
  mesh.node_id.assign(static_cast<std::size_t>(nodes), 0);
  mesh.blocks = std::move(blocks);
  return mesh;
}

const std::array<Vec3, 8> cube{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0},
                               Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{1, 1, 1}, Vec3{0, 1, 1}};

}  // namespace

TEST_CASE("the normals of all faces point outwards", "[topology]") {
  const std::array<LocalIndex, 8> hex{0, 1, 2, 3, 4, 5, 6, 7};
  for (int f = 0; f < 6; ++f) {
    const Face n = face_nodes(Shape::hex8, hex.data(), f);
    const auto at = [&](std::size_t k) { return cube[static_cast<std::size_t>(n[k])]; };
    const Vec3 normal = (at(2) - at(0)).cross(at(3) - at(1));
    CHECK(normal.dot(0.25 * (at(0) + at(1) + at(2) + at(3)) - Vec3::Constant(0.5)) > 0);
  }
  const std::array<LocalIndex, 4> tet{0, 1, 3, 4};
  for (int f = 0; f < 4; ++f) {
    const Face n = face_nodes(Shape::tet4, tet.data(), f);
    const auto at = [&](std::size_t k) { return cube[static_cast<std::size_t>(n[k])]; };
    CHECK(n[3] == no_index);
    const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0));
    CHECK(normal.dot((at(0) + at(1) + at(2)) / 3 - Vec3::Constant(0.25)) > 0);
  }
}

TEST_CASE("a wedge has two triangles, three quadrilaterals and a face that is no face", "[topology]") {
  const std::array<LocalIndex, 8> wedge{0, 1, 2, 2, 3, 4, 5, 5};
  CHECK(face_nodes(Shape::hex8, wedge.data(), 0) == Face{0, 1, 4, 3});
  CHECK(face_nodes(Shape::hex8, wedge.data(), 1) == Face{1, 2, 5, 4});
  CHECK(face_nodes(Shape::hex8, wedge.data(), 2) == Face{no_index, no_index, no_index, no_index});
  CHECK(face_nodes(Shape::hex8, wedge.data(), 3) == Face{0, 3, 5, 2});
  CHECK(face_nodes(Shape::hex8, wedge.data(), 4) == Face{0, 2, 1, no_index});
  CHECK(face_nodes(Shape::hex8, wedge.data(), 5) == Face{3, 4, 5, no_index});
}

TEST_CASE("shared faces are interior, across blocks and shapes too", "[topology]") {
  // hexes 0 and 1 share a quadrilateral; a wedge and a tet share a triangle
  const Mesh hexes = mesh_of(12, {{"a", 1, Shape::hex8, {0, 1, 2, 3, 4, 5, 6, 7}, {1}},
                                  {"b", 2, Shape::hex8, {4, 5, 6, 7, 8, 9, 10, 11}, {2}}});
  const auto sides = exterior_sides(hexes);
  REQUIRE(sides.size() == 10);
  CHECK(std::is_sorted(sides.begin(), sides.end()));
  for (const Side& s : sides) CHECK_FALSE((s == Side{0, 0, 5} || s == Side{1, 0, 4}));

  const Mesh mixed =
      mesh_of(7, {{"w", 1, Shape::hex8, {0, 1, 2, 2, 3, 4, 5, 5}, {1}}, {"t", 2, Shape::tet4, {3, 4, 5, 6}, {2}}});
  CHECK(exterior_sides(mixed).size() == 4 + 3);
}

TEST_CASE("bodies are numbered by their first element", "[topology]") {
  const Mesh mesh = mesh_of(13, {{"a", 1, Shape::tet4, {9, 10, 11, 12, 0, 1, 2, 3}, {1, 2}},
                                 {"b", 2, Shape::tet4, {5, 6, 7, 8, 3, 4, 5, 6, 12, 10, 11, 9}, {3, 4, 5}}});
  CHECK(bodies(mesh) == std::vector<std::int32_t>{0, 1, 1, 1, 0});
}

TEST_CASE("interior sides are those that another element shares, where all their nodes are wanted", "[topology]") {
  Block row{.name = "row", .shape = Shape::hex8, .nodes = {}, .element_id = {1, 2, 3}};
  for (LocalIndex e = 0; e < 3; ++e)  // three cubes on each other, four nodes a level
    for (LocalIndex n = 0; n < 8; ++n) row.nodes.push_back(4 * e + n);
  const Mesh mesh = mesh_of(16, {row});
  const std::vector<char> all(16, 1);
  CHECK(interior_sides(mesh, all) == std::vector<Side>{{0, 0, 5}, {0, 1, 4}, {0, 1, 5}, {0, 2, 4}});
  std::vector<char> lowest(16, 0);
  std::fill_n(lowest.begin(), 8, 1);
  CHECK(interior_sides(mesh, lowest) == std::vector<Side>{{0, 0, 5}, {0, 1, 4}});
}
