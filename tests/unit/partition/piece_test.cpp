// SPDX-License-Identifier: Apache-2.0
// Two hexahedra cut apart: what each piece holds, numbered by hand. (tests/ranks checks whole meshes on real ranks.)
#include "partition/piece.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "mesh/topology.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;
using partition::Cutter;

namespace {

/// The face of an element whose nodes all lie at x = 1, where the two elements meet.
std::int32_t face_at_joint(const mesh::Mesh& mesh, LocalIndex element) {
  const mesh::Block& block = mesh.blocks[0];
  for (std::int32_t face = 0; face < 6; ++face) {
    const auto nodes = mesh::face_nodes(block.shape, block.element(element), face);
    if (std::ranges::all_of(nodes, [&](LocalIndex n) { return mesh.coordinates[static_cast<std::size_t>(n)][0] == 1; }))
      return face;
  }
  return -1;
}

/// Nodes i + 3 (j + 2 k); the input held nodes and elements in the opposite order.
mesh::CanonicalMesh two_cubes() {
  mesh::CanonicalMesh whole;
  whole.mesh = partition::test::box({2, 1, 1});
  whole.origin = {7, 0, 0};
  whole.input_node.resize(12);
  std::iota(whole.input_node.rbegin(), whole.input_node.rend(), 0);
  whole.input_element = {{1, 0}};
  whole.mesh.node_sets["ends"] = {2, 0, 2};
  const mesh::Side left{0, 0, face_at_joint(whole.mesh, 0)}, right{0, 1, face_at_joint(whole.mesh, 1)};
  whole.mesh.side_sets["joint"] = {right, left, right};
  return whole;
}

}  // namespace

TEST_CASE("a piece has the nodes of its elements, and names the rank that shares some") {
  const mesh::CanonicalMesh whole = two_cubes();
  const std::vector<Rank> part{0, 1};
  Cutter cutter(whole, part, 2);
  const mesh::LocalMesh right = cutter.piece(1);
  CHECK(right.global_nodes == 12);
  CHECK(right.global_elements == 2);
  CHECK(right.origin == Vec3(7, 0, 0));
  CHECK(right.node_gid == std::vector<GlobalIndex>{1, 2, 4, 5, 7, 8, 10, 11});
  CHECK(right.input_node == std::vector<GlobalIndex>{10, 9, 7, 6, 4, 3, 1, 0});
  CHECK(right.owner == std::vector<Rank>{0, 1, 0, 1, 0, 1, 0, 1});
  CHECK(right.shared == std::vector<LocalIndex>{0, 2, 4, 6});
  CHECK(right.sharers.values == std::vector<Rank>{0, 0, 0, 0});
  REQUIRE(right.blocks.size() == 1);
  CHECK(right.blocks[0].gid == std::vector<GlobalIndex>{1});
  CHECK(right.blocks[0].input == std::vector<GlobalIndex>{0});
  CHECK(right.blocks[0].nodes == std::vector<LocalIndex>{0, 1, 3, 2, 4, 5, 7, 6});
}

TEST_CASE("faces and sets go with their elements; a side listed twice counts once") {
  const mesh::CanonicalMesh whole = two_cubes();
  const std::vector<Rank> part{0, 1};
  Cutter cutter(whole, part, 2);
  for (const Rank rank : {0, 1}) {
    const mesh::LocalMesh piece = cutter.piece(rank);
    CHECK(piece.faces.size() == 5);
    CHECK(std::ranges::is_sorted(piece.faces, {}, &mesh::ExteriorFace::key));
    for (const mesh::ExteriorFace& face : piece.faces) CHECK(face.key / 8 == rank);
    const auto& joint = piece.side_sets.at("joint");
    REQUIRE(joint.size() == 1);
    CHECK(joint[0].key == rank * 8 + face_at_joint(whole.mesh, rank));
    for (const LocalIndex node : joint[0].nodes) CHECK(piece.coordinates[static_cast<std::size_t>(node)][0] == 1);
    CHECK(piece.node_sets.at("ends") == std::vector<LocalIndex>{rank == 0 ? 0 : 1});
  }
}

TEST_CASE("pieces are cut in any order, and again") {
  const mesh::CanonicalMesh whole = two_cubes();
  const std::vector<Rank> part{0, 1};
  Cutter cutter(whole, part, 2);
  const mesh::LocalMesh before = cutter.piece(0);
  cutter.piece(1);
  const mesh::LocalMesh after = cutter.piece(0);
  CHECK(before.node_gid == after.node_gid);
  CHECK(before.blocks[0].nodes == after.blocks[0].nodes);
}

TEST_CASE("a rank without elements still knows every block and set by name") {
  const mesh::CanonicalMesh whole = two_cubes();
  const std::vector<Rank> part{2, 2};
  const mesh::LocalMesh piece = Cutter(whole, part, 3).piece(1);
  CHECK(piece.node_gid.empty());
  CHECK(piece.faces.empty());
  CHECK(piece.block_name == std::vector<std::string>{"box"});
  CHECK(piece.node_sets.at("ends").empty());
  CHECK(piece.side_sets.at("joint").empty());
}

TEST_CASE("a part for each element, and each a rank") {
  const mesh::CanonicalMesh whole = two_cubes();
  CHECK_THROWS(Cutter(whole, std::vector<Rank>{0}, 2));
  CHECK_THROWS(Cutter(whole, std::vector<Rank>{0, 2}, 2));
  CHECK_THROWS(Cutter(whole, std::vector<Rank>{0, -1}, 2));
}
