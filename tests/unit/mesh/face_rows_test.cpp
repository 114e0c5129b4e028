// SPDX-License-Identifier: Apache-2.0
// Every face is in the row of its lowest node once, and its side is told back.
#include "mesh/face_rows.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "mesh/primitives.hpp"

using namespace brunt;
using namespace brunt::mesh;

namespace {

Mesh wedge_and_tet() {
  Mesh mesh;
  mesh.coordinates.assign(7, Vec3::Zero());
  mesh.blocks = {{"w", 1, Shape::hex8, {0, 1, 2, 2, 3, 4, 5, 5}, {1}}, {"t", 2, Shape::tet4, {3, 4, 5, 6}, {2}}};
  return mesh;
}

}  // namespace

TEST_CASE("face rows: all faces of a box, those of two elements twice", "[face_rows]") {
  const Mesh mesh = box("b", {1, 1, 1}, {4, 3, 2});
  std::size_t faces = 0, pairs = 0;
  LocalIndex last_lowest = -1;
  FaceRows(mesh).for_each_row([&](std::span<const KeyedFace> row) {
    const LocalIndex lowest = row.front().key[0];
    CHECK(lowest > last_lowest);
    last_lowest = lowest;
    for (std::size_t i = 0; i < row.size(); ++i) {
      CHECK(row[i].key[0] == lowest);
      CHECK(std::ranges::is_sorted(row[i].key));
      for (std::size_t j = i + 1; j < row.size(); ++j) pairs += row[i].same_nodes(row[j]) ? 1 : 0;
    }
    faces += row.size();
  });
  CHECK(faces == 6 * 24);
  CHECK(pairs == 3 * 3 * 2 + 4 * 2 * 2 + 4 * 3 * 1);
}

TEST_CASE("face rows: collapsed faces are none, and sides name block, element and face", "[face_rows]") {
  const Mesh mesh = wedge_and_tet();
  const FaceRows rows(mesh);
  std::vector<Side> sides;
  rows.for_each_row([&](std::span<const KeyedFace> row) {
    for (const KeyedFace& face : row) {
      const Side side = rows.side(face);
      sides.push_back(side);
      const Block& block = mesh.blocks[static_cast<std::size_t>(side.block)];
      auto nodes = face_nodes(block.shape, block.element(side.element), side.face);
      std::ranges::sort(nodes);
      CHECK(nodes == face.key);
    }
  });
  std::ranges::sort(sides);
  CHECK(sides ==
        std::vector<Side>{
            {0, 0, 0}, {0, 0, 1}, {0, 0, 3}, {0, 0, 4}, {0, 0, 5}, {1, 0, 0}, {1, 0, 1}, {1, 0, 2}, {1, 0, 3}});
}
