// SPDX-License-Identifier: Apache-2.0
// Who owns a surface node, what lies around it, and the figures of the bodies, on any number of ranks.
#include "contact/joined/join_surface.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "comm/rendezvous.hpp"
#include "tests/support/small_mesh.hpp"

using namespace brunt;

namespace {

constexpr double held_above = 2.5;

/// Two boxes apart: of 3 x 2 x 2 elements 1 x 1 x 0.5, and of one element 2 x 2 x 0.4 whose nodes cannot move.
struct Boxes {
  comm::Communicator ranks = comm::Communicator::world();
  mesh::LocalMesh mesh;
  std::vector<char> excluded;
  std::vector<double> inverse_mass;

  Boxes() {
    mesh::Mesh whole;
    support::append_box(whole, {0, 0, 0}, {3, 2, 1}, {3, 2, 2});
    support::append_box(whole, {0, 0, 3}, {2, 2, 0.4}, {1, 1, 1});
    mesh =
        support::deal_out(whole, ranks.rank(), [&](GlobalIndex gid) { return static_cast<Rank>(gid % ranks.size()); });
    mesh.blocks.resize(2);
    excluded.assign(mesh.faces.size(), 0);
    for (const Vec3& x : mesh.coordinates) inverse_mass.push_back(x.z() > held_above ? 0.0 : 1 / (2 + x.x()));
  }
  /// Faces in the plane x = 0 touch nothing.
  void exclude_plane() {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      excluded[f] =
          std::ranges::all_of(mesh.faces[f].nodes,
                              [&](LocalIndex n) { return mesh.coordinates[static_cast<std::size_t>(n)].x() == 0; })
              ? 1
              : 0;
  }
  [[nodiscard]] contact::Surface join() const { return contact::join_surface(ranks, mesh, excluded, inverse_mass); }
  [[nodiscard]] const Vec3& place(const contact::Surface& surface, std::size_t node) const {
    return mesh.coordinates[static_cast<std::size_t>(surface.model_node[node])];
  }
};

}  // namespace

TEST_CASE("surface: every copy names the place on the owner where the node is, and each node has one owner") {
  const Boxes boxes;
  const contact::Surface surface = boxes.join();
  struct Asked {
    LocalIndex index = 0;
    GlobalIndex gid = 0;
  };
  std::vector<std::vector<Asked>> to_owner(static_cast<std::size_t>(boxes.ranks.size()));
  GlobalIndex owned = 0;
  for (std::size_t i = 0; i < surface.gid.size(); ++i) {
    to_owner[static_cast<std::size_t>(surface.home[i].rank)].push_back({surface.home[i].index, surface.gid[i]});
    CHECK(surface.home[i].rank == boxes.mesh.owner[static_cast<std::size_t>(surface.model_node[i])]);
    if (surface.owns(static_cast<LocalIndex>(i), boxes.ranks.rank())) ++owned;
  }
  for (const Asked& asked : comm::exchange(boxes.ranks, to_owner).values)
    CHECK(surface.gid[static_cast<std::size_t>(asked.index)] == asked.gid);
  CHECK(boxes.ranks.sum(owned) == (4 * 3 * 3 - 2) + 8);  // the larger box has two nodes inside
}

TEST_CASE("surface: owners know all faces around a node, of all ranks; excluded ones are not among them") {
  Boxes boxes;
  boxes.exclude_plane();
  const contact::Surface surface = boxes.join();
  GlobalIndex around = 0, faces = static_cast<GlobalIndex>(surface.faces.size());
  for (std::size_t i = 0; i < surface.gid.size(); ++i) {
    const auto node = static_cast<LocalIndex>(i);
    if (!surface.owns(node, boxes.ranks.rank())) {
      CHECK(surface.facets.row(node).empty());
      continue;
    }
    const Vec3& x = boxes.place(surface, i);
    const bool large = x.z() < held_above;
    CHECK(surface.body[i] == (large ? 0 : 1));
    // of the three ways to leave a box, each that the node's place has, times the elements along the other two
    const Vec3 size = large ? Vec3(3, 2, 1) : Vec3(2, 2, 0.4), low = large ? Vec3(0, 0, 0) : Vec3(0, 0, 3);
    std::size_t expected = 0;
    for (int c = 0; c < 3; ++c) {
      const auto outer = [&](int k) { return x[k] == low[k] || x[k] == low[k] + size[k]; };
      if (!outer(c) || (c == 0 && x.x() == 0)) continue;
      expected += (outer((c + 1) % 3) ? 1U : 2U) * (outer((c + 2) % 3) ? 1U : 2U);
    }
    CHECK(surface.facets.row(node).size() == expected);
    CHECK(std::ranges::is_sorted(surface.blocks.row(node)));
    CHECK(surface.blocks.row(node).size() == (expected > 0 ? 1U : 0U));
    around += static_cast<GlobalIndex>(surface.facets.row(node).size());
  }
  CHECK(boxes.ranks.sum(around) == 4 * boxes.ranks.sum(faces));
  CHECK(boxes.ranks.sum(faces) == 2 * (6 + 6 + 4) - 4 + 6 - 1);
}

TEST_CASE("surface: figures of the bodies are those of the whole model on every rank") {
  const contact::Surface surface = Boxes().join();
  REQUIRE(surface.bodies.size() == 2);
  const double area = 2 * (3 * 2 + 3 * 1 + 2 * 1.0);
  CHECK(surface.bodies[0].mean_area == Approx(area / 32).epsilon(1e-14));
  CHECK(surface.bodies[1].mean_area == Approx((2 * 4 + 4 * 0.8) / 6).epsilon(1e-14));
  // x = 0 and 3 have 9 nodes each of the mass 2 and 5, x = 1 and 2 the 8 at the rim of 3 and 4
  CHECK(surface.bodies[0].mean_mass == Approx((9 * 2 + 9 * 5 + 8 * 3 + 8 * 4) / 34.0).epsilon(1e-14));
  CHECK(std::isinf(surface.bodies[1].mean_mass));
  CHECK(surface.bodies[0].blocks == std::vector<std::int32_t>{0});
  CHECK(surface.bodies[1].blocks == std::vector<std::int32_t>{1});
  CHECK(surface.mean_edge == Approx((32 * 1.0 + 6 * 2.0) / 38).epsilon(1e-14));
}
