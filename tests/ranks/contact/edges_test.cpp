// SPDX-License-Identifier: Apache-2.0
// Edges of the surface and neighbours of its nodes, on any number of ranks, against a count by hand.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <numbers>
#include <set>

#include "contact/joined/join_surface.hpp"
#include "tests/support/small_mesh.hpp"

using namespace brunt;

namespace {

Rank by_stripes(GlobalIndex gid, int ranks) {
  return static_cast<Rank>((gid / 3 * 7 + gid % 2) % ranks);
}

/// deal_out gives faces; here come the elements behind them.
mesh::LocalMesh with_elements(const mesh::Mesh& whole, const comm::Communicator& ranks) {
  const auto rank_of = [&](GlobalIndex gid) { return by_stripes(gid, ranks.size()); };
  mesh::LocalMesh local = support::deal_out(whole, ranks.rank(), rank_of);
  std::map<GlobalIndex, LocalIndex> here;
  for (std::size_t n = 0; n < local.node_gid.size(); ++n) here[local.node_gid[n]] = static_cast<LocalIndex>(n);
  GlobalIndex gid = 0;
  for (const mesh::Block& block : whole.blocks) {
    mesh::LocalBlock& mine = local.blocks.emplace_back();
    for (LocalIndex e = 0; e < block.count(); ++e, ++gid) {
      if (rank_of(gid) != ranks.rank()) continue;
      mine.gid.push_back(gid);
      for (int i = 0; i < 8; ++i) mine.nodes.push_back(here.at(block.element(e)[i]));
    }
  }
  return local;
}

contact::Surface surface_of(const mesh::Mesh& whole, const comm::Communicator& ranks) {
  const mesh::LocalMesh local = with_elements(whole, ranks);
  return contact::join_surface(ranks, local, std::vector<char>(local.faces.size(), 0),
                               std::vector<double>(local.node_gid.size(), 1.0));
}

/// A block of 6 x 2 x 3 elements with a groove, 2 x 2 x 1, along its top: elements in the groove are left out.
mesh::Mesh grooved() {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {6, 2, 3}, {6, 2, 3});
  std::vector<LocalIndex> kept;
  for (LocalIndex e = 0; e < mesh.blocks[0].count(); ++e)
    if (!(e / 12 == 2 && (e % 6 == 2 || e % 6 == 3)))
      kept.insert(kept.end(), mesh.blocks[0].element(e), mesh.blocks[0].element(e) + 8);
  mesh.blocks[0].nodes = kept;
  return mesh;
}

using Edge = std::array<GlobalIndex, 2>;

/// (lower gid, higher gid) of all ranks' edges of this kind, in the order of ranks; none may be there twice.
GlobalIndex count_edges(const comm::Communicator& ranks, const contact::Surface& surface, std::set<Edge>& own,
                        contact::EdgeKind kind = contact::EdgeKind::sharp) {
  for (const contact::SurfaceEdge& edge : surface.edges) {
    if (edge.kind != kind) continue;
    const Edge ends{surface.gid[static_cast<std::size_t>(edge.nodes[0])],
                    surface.gid[static_cast<std::size_t>(edge.nodes[1])]};
    CHECK(ends[0] < ends[1]);
    CHECK(own.insert(ends).second);
  }
  return ranks.sum(static_cast<GlobalIndex>(own.size()));
}

}  // namespace

TEST_CASE("a cube of n^3 elements has 12 n sharp edges on any number of ranks, each on one rank") {
  const comm::Communicator world = comm::Communicator::world();
  for (const int n : {1, 3, 4}) {
    mesh::Mesh mesh;
    support::append_box(mesh, {0, 0, 0}, {1, 1, 1}, {n, n, n});
    std::set<Edge> own;
    CHECK(count_edges(world, surface_of(mesh, world), own) == 12 * n);
    for (const auto& [low, high] : own) {  // on two of the cube's sides at once
      int extreme = 0;
      for (int c = 0; c < 3; ++c) {
        const double a = mesh.coordinates[static_cast<std::size_t>(low)][c],
                     b = mesh.coordinates[static_cast<std::size_t>(high)][c];
        extreme += static_cast<int>(a == b && (a == 0 || a == 1));
      }
      CHECK(extreme == 2);
    }
    std::set<Edge> flat;  // n (n - 1) either way on each side
    CHECK(count_edges(world, surface_of(mesh, world), flat, contact::EdgeKind::flat) == 12 * n * (n - 1));
    std::set<Edge> blunt;
    CHECK(count_edges(world, surface_of(mesh, world), blunt, contact::EdgeKind::blunt) == 0);
  }
}

TEST_CASE("a groove has sharp edges at its rims and none at its bottom") {
  const comm::Communicator world = comm::Communicator::world();
  const mesh::Mesh mesh = grooved();
  std::set<Edge> own;
  // 4 x 6 along x, less 2 x 2 at the mouth of the groove, and 2 x 2 across its ends' floors; 4 x 2 along y at the
  // block's sides and 2 x 2 at the rims; 4 x 3 along z at the block's and 4 x 1 at the groove's ends
  CHECK(count_edges(world, surface_of(mesh, world), own) == (4 * 6 - 2 * 2 + 2 * 2) + (4 * 2 + 2 * 2) + (4 * 3 + 4));
  for (const auto& [low, high] : own) {
    const Vec3 &a = mesh.coordinates[static_cast<std::size_t>(low)],
               &b = mesh.coordinates[static_cast<std::size_t>(high)];
    const bool along_y = a.x() == b.x() && a.z() == b.z();
    CHECK_FALSE((along_y && a.z() == 2 && (a.x() == 2 || a.x() == 4)));  // the bottom
  }
}

TEST_CASE("edges and neighbours are those of one rank") {
  const comm::Communicator world = comm::Communicator::world();
  const mesh::Mesh mesh = grooved();
  const contact::Surface whole = surface_of(mesh, comm::Communicator::self()), part = surface_of(mesh, world);
  for (const auto kind : {contact::EdgeKind::sharp, contact::EdgeKind::flat}) {
    std::set<Edge> expected, own;
    CHECK(count_edges(comm::Communicator::self(), whole, expected, kind) == count_edges(world, part, own, kind));
    CHECK(std::ranges::includes(expected, own));
  }

  std::map<GlobalIndex, std::set<GlobalIndex>> around;  // by hand
  for (LocalIndex e = 0; e < mesh.blocks[0].count(); ++e) {
    const std::span<const LocalIndex> nodes(mesh.blocks[0].element(e), 8);
    for (const LocalIndex node : nodes) around[node].insert(nodes.begin(), nodes.end());
  }
  GlobalIndex seen = 0;
  for (std::size_t n = 0; n < part.gid.size(); ++n) {
    const auto row = part.neighbours.row(static_cast<LocalIndex>(n));
    if (!part.owns(static_cast<LocalIndex>(n), world.rank())) {
      CHECK(row.empty());
      continue;
    }
    ++seen;
    const std::set<GlobalIndex>& known = around.at(part.gid[n]);
    CHECK(std::ranges::equal(row, known));
  }
  CHECK(world.sum(seen) == static_cast<GlobalIndex>(whole.gid.size()));
}
