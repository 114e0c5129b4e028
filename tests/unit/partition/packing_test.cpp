// SPDX-License-Identifier: Apache-2.0
// A packed piece comes back as it was; a cut one is refused.
#include "partition/packing.hpp"

#include <catch2/catch.hpp>
#include <span>

#include "core/error.hpp"

using namespace brunt;

TEST_CASE("a piece survives packing") {
  mesh::LocalMesh piece;
  piece.global_nodes = 7;
  piece.origin = Vec3(1, 2, 3);
  piece.coordinates = {Vec3(0.5, -1, 2), Vec3(4, 5, 6)};
  piece.node_gid = {3, 5};
  piece.shared = {1};
  piece.sharers.values = {0, 2};
  piece.sharers.close_row();
  piece.block_name = {"", "plate"};
  piece.blocks.resize(2);
  piece.blocks[1].shape = mesh::Shape::tet4;
  piece.blocks[1].nodes = {0, 1, 1, 0};
  piece.node_sets["empty"] = {};
  piece.side_sets["top"] = {mesh::ExteriorFace{8, {0, 1, 1, no_index}, 1, 4}};

  const auto bytes = partition::pack(piece);
  const mesh::LocalMesh back = partition::unpack(bytes);
  CHECK(back.global_nodes == 7);
  CHECK(back.origin == Vec3(1, 2, 3));
  CHECK(back.coordinates == piece.coordinates);
  CHECK(back.node_gid == piece.node_gid);
  CHECK(back.sharers.offsets == piece.sharers.offsets);
  CHECK(back.sharers.values == piece.sharers.values);
  CHECK(back.block_name == piece.block_name);
  REQUIRE(back.blocks.size() == 2);
  CHECK(back.blocks[1].shape == mesh::Shape::tet4);
  CHECK(back.blocks[1].nodes == piece.blocks[1].nodes);
  CHECK(back.node_sets.count("empty") == 1);
  REQUIRE(back.side_sets.at("top").size() == 1);
  CHECK(back.side_sets.at("top")[0].body == 4);
  CHECK(back.side_sets.at("top")[0].nodes[3] == no_index);
}

TEST_CASE("a piece that lost or gained bytes is refused") {
  auto bytes = partition::pack(mesh::LocalMesh{});
  CHECK_THROWS(partition::unpack(std::span(bytes).first(bytes.size() - 1)));
  bytes.push_back(std::byte{0});
  CHECK_THROWS(partition::unpack(bytes));
}
