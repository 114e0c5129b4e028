// SPDX-License-Identifier: Apache-2.0
// The outside of a box that loses elements, dealt out to ranks at random: against the faces counted on the whole mesh.
#include "surface/exposed.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "comm/rendezvous.hpp"
#include "tests/support/small_mesh.hpp"

using namespace brunt;

namespace {

/// Two boxes, of 3 x 3 x 3 and of 2 x 1 x 1 elements, dealt out by a hash of their number.
struct Boxes {
  comm::Communicator ranks = comm::Communicator::world();
  mesh::Mesh whole;
  mesh::LocalMesh mesh;

  Boxes() {
    support::append_box(whole, {0, 0, 0}, {3, 3, 3}, {3, 3, 3});
    support::append_box(whole, {0, 0, 5}, {2, 1, 1}, {2, 1, 1});
    mesh = support::deal_out(whole, ranks.rank(), [this](GlobalIndex gid) { return rank_of(gid); });
  }
  [[nodiscard]] Rank rank_of(GlobalIndex gid) const { return static_cast<Rank>(gid * 7 % 5 % ranks.size()); }
  [[nodiscard]] LocalIndex local_node(GlobalIndex gid) const {
    return static_cast<LocalIndex>(std::ranges::lower_bound(mesh.node_gid, gid) - mesh.node_gid.begin());
  }
  /// Both sides of all faces that two elements share, of this rank's elements.
  [[nodiscard]] std::vector<mesh::ExteriorFace> inner() const {
    std::vector<mesh::ExteriorFace> faces;
    const std::vector<char> all(whole.coordinates.size(), 1);
    for (const mesh::Side& side : mesh::interior_sides(whole, all)) {
      const auto b = static_cast<std::size_t>(side.block);
      const GlobalIndex gid = side.element + (side.block == 0 ? 0 : whole.blocks[0].count());
      if (rank_of(gid) != ranks.rank()) continue;
      mesh::ExteriorFace face{.key = gid * 8 + side.face, .nodes = {}, .block = side.block, .body = side.block};
      face.nodes = mesh::face_nodes(whole.blocks[b].shape, whole.blocks[b].element(side.element), side.face);
      for (LocalIndex& node : face.nodes)
        if (node != no_index) node = local_node(node);
      faces.push_back(face);
    }
    return faces;
  }
  [[nodiscard]] std::vector<std::vector<double>> alive(const std::set<GlobalIndex>& removed) const {
    std::vector<std::vector<double>> flags;
    for (const mesh::LocalBlock& block : mesh.blocks) {
      flags.emplace_back();
      for (const GlobalIndex gid : block.gid) flags.back().push_back(removed.contains(gid) ? 0.0 : 1.0);
    }
    return flags;
  }
};

/// Keys of the faces outside, and gids of the nodes without an element, from the whole mesh alone.
struct Oracle {
  std::set<GlobalIndex> faces, bare;
  Oracle(const mesh::Mesh& whole, const std::set<GlobalIndex>& removed) {
    std::map<std::array<LocalIndex, 4>, std::vector<GlobalIndex>> living;
    std::set<GlobalIndex> held;
    GlobalIndex gid = 0;
    for (const mesh::Block& block : whole.blocks)
      for (LocalIndex e = 0; e < block.count(); ++e, ++gid) {
        for (int c = 0; c < 8; ++c) (removed.contains(gid) ? bare : held).insert(block.element(e)[c]);
        for (int f = 0; f < 6 && !removed.contains(gid); ++f) {
          auto nodes = mesh::face_nodes(block.shape, block.element(e), f);
          std::ranges::sort(nodes);
          living[nodes].push_back(gid * 8 + f);
        }
      }
    for (const auto& [nodes, keys] : living)
      if (keys.size() == 1) faces.insert(keys[0]);
    for (const GlobalIndex node : held) bare.erase(node);
  }
};

std::set<GlobalIndex> gathered(const comm::Communicator& ranks, const std::vector<GlobalIndex>& mine) {
  const std::vector<std::vector<GlobalIndex>> to_all(static_cast<std::size_t>(ranks.size()), mine);
  const std::vector<GlobalIndex> all = comm::exchange(ranks, to_all).values;
  return {all.begin(), all.end()};
}

void check_outside(const Boxes& boxes, const surface::InnerFaces& inner, const std::set<GlobalIndex>& removed) {
  const std::vector<std::vector<double>> alive = boxes.alive(removed);
  const surface::ExposedSurface outside = surface::exposed_surface(boxes.ranks, boxes.mesh, inner, alive);
  const Oracle oracle(boxes.whole, removed);
  std::vector<GlobalIndex> keys, points, bare;
  for (const mesh::ExteriorFace& face : outside.faces) keys.push_back(face.key);
  CHECK(std::ranges::is_sorted(keys));
  for (const surface::MassPoint& point : outside.points)
    points.push_back(boxes.mesh.node_gid[static_cast<std::size_t>(point.node)]);
  for (const LocalIndex node : surface::bare_nodes(boxes.ranks, boxes.mesh, alive).kept)
    bare.push_back(boxes.mesh.node_gid[static_cast<std::size_t>(node)]);
  CHECK(gathered(boxes.ranks, keys) == oracle.faces);
  CHECK(gathered(boxes.ranks, points) == oracle.bare);
  CHECK(gathered(boxes.ranks, bare) == oracle.bare);
}

}  // namespace

TEST_CASE("surface: with all elements the outside is what the mesh says, without any there is none", "[surface]") {
  const Boxes boxes;
  const surface::InnerFaces inner = surface::join_faces(boxes.ranks, boxes.mesh, boxes.inner());
  check_outside(boxes, inner, {});
  std::set<GlobalIndex> all;
  for (GlobalIndex gid = 0; gid < 29; ++gid) all.insert(gid);
  check_outside(boxes, inner, all);
}

TEST_CASE("surface: a face is outside where exactly one of its elements lives, on whatever ranks they are",
          "[surface]") {
  const Boxes boxes;
  const surface::InnerFaces inner = surface::join_faces(boxes.ranks, boxes.mesh, boxes.inner());
  check_outside(boxes, inner, {13});                                      // a hole in the middle
  check_outside(boxes, inner, {18, 19, 20, 21, 22, 23, 24, 25, 26, 27});  // the upper layer, half of the other box
  std::set<GlobalIndex> removed;
  for (GlobalIndex k = 0; k < 29; ++k) {  // all, one after the other, in a disorder of 29 numbers
    removed.insert(k * 12 % 29);
    check_outside(boxes, inner, removed);
  }
}
