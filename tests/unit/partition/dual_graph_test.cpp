// SPDX-License-Identifier: Apache-2.0
// Elements that share a face, counted by hand.
#include "partition/dual_graph.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "mesh/shell_bodies.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;
using partition::dual_graph;

namespace {

std::vector<LocalIndex> row(const Ragged<LocalIndex>& graph, LocalIndex e) {
  return {graph.row(e).begin(), graph.row(e).end()};
}

}  // namespace

TEST_CASE("hexes in a 2 x 2 plate hang together by faces, not by edges") {
  const Ragged<LocalIndex> graph = dual_graph(partition::test::box({2, 2, 1}));
  REQUIRE(graph.rows() == 4);
  CHECK(row(graph, 0) == std::vector<LocalIndex>{1, 2});
  CHECK(row(graph, 1) == std::vector<LocalIndex>{0, 3});
  CHECK(row(graph, 2) == std::vector<LocalIndex>{0, 3});
  CHECK(row(graph, 3) == std::vector<LocalIndex>{1, 2});
}

TEST_CASE("a box of hexes has as many edges as inner faces") {
  const Ragged<LocalIndex> graph = dual_graph(partition::test::box({3, 4, 5}));
  CHECK(graph.values.size() == 2 * (2 * 4 * 5 + 3 * 3 * 5 + 3 * 4 * 4));
}

TEST_CASE("six tets around the diagonal of a cube form a ring") {
  const Ragged<LocalIndex> graph = dual_graph(partition::test::box({1, 1, 1}, mesh::Shape::tet4));
  REQUIRE(graph.rows() == 6);
  for (LocalIndex e = 0; e < 6; ++e) {
    std::vector<LocalIndex> ring{(e + 1) % 6, (e + 5) % 6};
    std::ranges::sort(ring);
    CHECK(row(graph, e) == ring);
  }
}

TEST_CASE("a tet on the triangular face of a wedge written as a hex is its neighbour") {
  mesh::Mesh mesh;
  mesh.coordinates.assign(7, Vec3::Zero());
  mesh.blocks.resize(2);
  mesh.blocks[0].nodes = {0, 1, 2, 2, 3, 4, 5, 5};  // triangles 0 1 2 and 3 4 5
  mesh.blocks[1].shape = mesh::Shape::tet4;
  mesh.blocks[1].nodes = {3, 4, 5, 6};
  const Ragged<LocalIndex> graph = dual_graph(mesh);
  CHECK(row(graph, 0) == std::vector<LocalIndex>{1});
  CHECK(row(graph, 1) == std::vector<LocalIndex>{0});
}

TEST_CASE("blocks without elements count nothing") {
  mesh::Mesh mesh;
  mesh.blocks.resize(1);
  partition::test::add_box(mesh, {2, 1, 1}, 0.0, mesh::Shape::hex8, "bar");
  CHECK(partition::first_of_block(mesh) == std::vector<LocalIndex>{0, 0, 2});
  CHECK(row(dual_graph(mesh), 1) == std::vector<LocalIndex>{0});
}

TEST_CASE("shells are neighbours by edges, and of the solid that they cover") {
  const Ragged<LocalIndex> plate = dual_graph(mesh::shell_plate("p", {2, 2}, {2, 2}));
  REQUIRE(plate.rows() == 4);
  CHECK(row(plate, 0) == std::vector<LocalIndex>{1, 2});
  CHECK(row(plate, 3) == std::vector<LocalIndex>{1, 2});
  CHECK(dual_graph(mesh::shell_box("b", Vec3(1, 1, 1), {3, 4, 5})).values.size() == 2 * 2 * (12 + 20 + 15) * 4 / 2);
  mesh::Mesh skin = mesh::box("b", Vec3(1, 1, 1), {1, 1, 1});
  skin.blocks.push_back({"skin", 2, mesh::Shape::tri3, {4, 5, 7, 4, 7, 6}, {1, 2}});
  skin.blocks.push_back({"lid", 3, mesh::Shape::quad4, {0, 2, 3, 1}, {1}});
  const Ragged<LocalIndex> graph = dual_graph(skin);
  CHECK(row(graph, 0) == std::vector<LocalIndex>{3});  // of two triangles neither is its face
  CHECK(row(graph, 1) == std::vector<LocalIndex>{2});
}
