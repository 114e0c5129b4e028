// SPDX-License-Identifier: Apache-2.0
// The pieces of the ranks together are the whole mesh: two bodies, hexes with a corner cut by tets, sets, and every
// kind of split, with ranks that get nothing.
#include "partition/distribute.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/topology.hpp"
#include "partition/dual_graph.hpp"
#include "partition/split.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;
using comm::Communicator;

namespace {

mesh::CanonicalMesh two_bodies() {
  mesh::Mesh mesh;
  partition::test::add_box(mesh, {3, 2, 2}, 100.0, mesh::Shape::hex8, "bar");
  partition::test::add_box(mesh, {2, 2, 1}, 110.0, mesh::Shape::tet4, "plate");
  mesh.blocks.emplace_back().name = "nothing";
  mesh.node_sets["ends"] = {0, 3, 36};
  mesh.node_sets["none"] = {};
  mesh.side_sets["inside"] = {{0, 0, 1}, {0, 1, 3}};  // both sides of one inner face
  mesh.side_sets["bottom"] = {{1, 0, 3}, {0, 2, 4}, {0, 0, 4}};
  return mesh::canonical_order(std::move(mesh));
}

/// What every rank may know of the whole, made without the code under test.
struct Whole {
  std::vector<std::vector<LocalIndex>> element;  // its nodes
  std::vector<std::set<Rank>> holders;           // of each node
  std::vector<Rank> owner;

  Whole(const mesh::Mesh& mesh, const std::vector<Rank>& part)
      : holders(mesh.coordinates.size()), owner(mesh.coordinates.size(), -1) {
    for (const mesh::Block& block : mesh.blocks)
      for (LocalIndex e = 0; e < block.count(); ++e) {
        const Rank rank = part[element.size()];
        element.emplace_back(block.element(e), block.element(e) + mesh::nodes_per_element(block.shape));
        for (const LocalIndex node : element.back()) {
          const auto n = static_cast<std::size_t>(node);
          holders[n].insert(rank);
          if (owner[n] < 0) owner[n] = rank;
        }
      }
  }
};

void check_nodes(const mesh::LocalMesh& piece, const mesh::CanonicalMesh& whole, const Whole& known, Rank rank) {
  CHECK(std::ranges::is_sorted(piece.node_gid));
  CHECK(std::ranges::is_sorted(piece.shared));
  REQUIRE(piece.sharers.rows() == static_cast<LocalIndex>(piece.shared.size()));
  std::map<LocalIndex, LocalIndex> shared_row;
  for (std::size_t i = 0; i < piece.shared.size(); ++i) shared_row[piece.shared[i]] = static_cast<LocalIndex>(i);
  for (std::size_t i = 0; i < piece.node_gid.size(); ++i) {
    const auto gid = static_cast<std::size_t>(piece.node_gid[i]);
    CHECK(piece.coordinates[i] == whole.mesh.coordinates[gid]);
    CHECK(piece.node_id[i] == whole.mesh.node_id[gid]);
    CHECK(piece.input_node[i] == whole.input_node[gid]);
    CHECK(piece.owner[i] == known.owner[gid]);
    std::set<Rank> others = known.holders[gid];
    REQUIRE(others.erase(rank) == 1);
    const auto row = shared_row.find(static_cast<LocalIndex>(i));
    REQUIRE((row != shared_row.end()) == !others.empty());
    if (others.empty()) continue;
    const auto sharers = piece.sharers.row(row->second);
    CHECK(std::ranges::equal(sharers, others));
  }
}

void check_elements(const mesh::LocalMesh& piece, const mesh::CanonicalMesh& whole, const Whole& known,
                    const std::vector<Rank>& part, Rank rank) {
  const std::vector<LocalIndex> first = partition::first_of_block(whole.mesh);
  REQUIRE(piece.blocks.size() == whole.mesh.blocks.size());
  for (std::size_t b = 0; b < piece.blocks.size(); ++b) {
    const mesh::LocalBlock& block = piece.blocks[b];
    CHECK(block.shape == whole.mesh.blocks[b].shape);
    CHECK(piece.block_name[b] == whole.mesh.blocks[b].name);
    CHECK(piece.block_id[b] == whole.mesh.blocks[b].id);
    std::vector<GlobalIndex> expected;
    for (GlobalIndex e = first[b]; e < first[b + 1]; ++e)
      if (part[static_cast<std::size_t>(e)] == rank) expected.push_back(e);
    REQUIRE(block.gid == expected);
    const auto width = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
    REQUIRE(block.nodes.size() == expected.size() * width);
    for (std::size_t e = 0; e < expected.size(); ++e) {
      const auto gid = static_cast<std::size_t>(expected[e]);
      CHECK(block.input[e] == whole.input_element[b][gid - static_cast<std::size_t>(first[b])]);
      for (std::size_t c = 0; c < width; ++c)
        CHECK(piece.node_gid[static_cast<std::size_t>(block.nodes[e * width + c])] == known.element[gid][c]);
    }
  }
}

void check_faces(const std::vector<mesh::ExteriorFace>& faces, std::vector<mesh::Side> sides,
                 const mesh::LocalMesh& piece, const mesh::CanonicalMesh& whole, const std::vector<Rank>& part,
                 Rank rank) {
  const std::vector<LocalIndex> first = partition::first_of_block(whole.mesh);
  const std::vector<std::int32_t> body = mesh::bodies(whole.mesh);
  std::map<GlobalIndex, mesh::Side> expected;
  for (const mesh::Side& side : sides) {
    const GlobalIndex gid = first[static_cast<std::size_t>(side.block)] + side.element;
    if (part[static_cast<std::size_t>(gid)] == rank) expected[gid * 8 + side.face] = side;
  }
  REQUIRE(faces.size() == expected.size());
  std::size_t i = 0;
  for (const auto& [key, side] : expected) {
    const mesh::ExteriorFace& face = faces[i++];
    CHECK(face.key == key);
    CHECK(face.block == side.block);
    CHECK(face.body == body[static_cast<std::size_t>(key / 8)]);
    const mesh::Block& block = whole.mesh.blocks[static_cast<std::size_t>(side.block)];
    const auto nodes = mesh::face_nodes(block.shape, block.element(side.element), side.face);
    for (std::size_t k = 0; k < 4; ++k)
      CHECK((nodes[k] == no_index ? face.nodes[k] == no_index
                                  : piece.node_gid[static_cast<std::size_t>(face.nodes[k])] == nodes[k]));
  }
}

void check_sets(const mesh::LocalMesh& piece, const mesh::CanonicalMesh& whole, const std::vector<Rank>& part,
                Rank rank) {
  REQUIRE(piece.node_sets.size() == whole.mesh.node_sets.size());
  for (const auto& [name, nodes] : whole.mesh.node_sets) {
    std::set<LocalIndex> expected;
    for (const LocalIndex node : nodes) {
      const auto found = std::ranges::find(piece.node_gid, node);
      if (found != piece.node_gid.end()) expected.insert(static_cast<LocalIndex>(found - piece.node_gid.begin()));
    }
    CHECK(std::ranges::equal(piece.node_sets.at(name), expected));
  }
  REQUIRE(piece.side_sets.size() == whole.mesh.side_sets.size());
  for (const auto& [name, sides] : whole.mesh.side_sets)
    check_faces(piece.side_sets.at(name), sides, piece, whole, part, rank);
}

void check_split(const std::function<Rank(LocalIndex, int)>& rank_of, Rank root = 0) {
  const Communicator ranks = Communicator::world();
  const mesh::CanonicalMesh whole = two_bodies();
  std::vector<Rank> part;
  for (LocalIndex e = 0; e < partition::first_of_block(whole.mesh).back(); ++e)
    part.push_back(rank_of(e, ranks.size()));
  const bool is_root = ranks.rank() == root;
  const mesh::LocalMesh piece =
      partition::distribute(ranks, is_root ? whole : mesh::CanonicalMesh{}, is_root ? part : std::vector<Rank>{}, root);
  const Whole known(whole.mesh, part);
  CHECK(piece.global_elements == 36);
  CHECK(piece.global_nodes == 36 + 18);
  CHECK(piece.origin == whole.origin);
  check_nodes(piece, whole, known, ranks.rank());
  check_elements(piece, whole, known, part, ranks.rank());
  check_faces(piece.faces, mesh::exterior_sides(whole.mesh), piece, whole, part, ranks.rank());
  check_sets(piece, whole, part, ranks.rank());

  const auto owned = std::ranges::count(piece.owner, ranks.rank());
  CHECK(ranks.sum(GlobalIndex{owned}) == piece.global_nodes);
  CHECK(ranks.sum(static_cast<GlobalIndex>(piece.faces.size())) == 32 + 32);  // 3x2x2 quads, 2x2x1 split in triangles
}

}  // namespace

TEST_CASE("the pieces are the whole, for contiguous parts") {
  check_split([](LocalIndex e, int n) { return e * n / 36; });
}

TEST_CASE("the pieces are the whole, for elements dealt out one by one") {
  check_split([](LocalIndex e, int n) { return e % n; });
}

TEST_CASE("the pieces are the whole, with nothing on the first ranks and the mesh on the last") {
  const Rank last = Communicator::world().size() - 1;
  check_split([](LocalIndex, int n) { return n - 1; }, last);
}

TEST_CASE("a mesh of one element goes to one rank, with its names on all") {
  const Communicator ranks = Communicator::world();
  mesh::Mesh one = partition::test::box({1, 1, 1});
  one.node_sets["corner"] = {0};
  const std::vector<Rank> part = partition::split(one, ranks.size());
  const mesh::LocalMesh piece = partition::distribute(ranks, mesh::canonical_order(std::move(one)), part);
  CHECK(ranks.sum(static_cast<GlobalIndex>(piece.blocks.at(0).gid.size())) == 1);
  CHECK(ranks.sum(static_cast<GlobalIndex>(piece.node_gid.size())) == 8);
  CHECK(piece.node_sets.count("corner") == 1);
  CHECK(piece.block_name == std::vector<std::string>{"box"});
  CHECK(piece.shared.empty());
}

TEST_CASE("nodes without an element go to the first rank") {
  const Communicator ranks = Communicator::world();
  mesh::CanonicalMesh whole = two_bodies();
  whole.mesh.coordinates.emplace_back(1, 2, 3);
  whole.mesh.node_id.push_back(99);
  whole.input_node.push_back(54);
  const std::vector<Rank> part = partition::split(whole.mesh, ranks.size());
  const mesh::LocalMesh piece = partition::distribute(ranks, whole, part);
  const bool has_it = std::ranges::find(piece.node_gid, GlobalIndex{54}) != piece.node_gid.end();
  CHECK(has_it == (ranks.rank() == 0));
}
