// SPDX-License-Identifier: Apache-2.0
// Seams between boxes that are flush, counted by hand, on any number of ranks.
#include "contact/joined/seams.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>

#include "contact/joined/join_surface.hpp"
#include "tests/support/small_mesh.hpp"

using namespace brunt;

namespace {

/// Boxes of 3 x 2 x 2 and 2 x 4 x 1 elements, a hundredth apart, the second one higher by `step`; one above the first.
contact::Surface boxes(const comm::Communicator& ranks, double step) {
  mesh::Mesh whole;
  support::append_box(whole, {0, 0, 0}, {3, 2, 1}, {3, 2, 2});
  support::append_box(whole, {3.01, 0, step}, {2, 2, 1}, {2, 4, 1});
  support::append_box(whole, {0, 0, 1.2}, {1, 1, 1}, {1, 1, 1});
  mesh::LocalMesh mesh = support::deal_out(whole, ranks.rank(),
                                           [&](GlobalIndex gid) { return static_cast<Rank>(gid * 7 % ranks.size()); });
  mesh.blocks.resize(3);
  const std::vector<char> excluded(mesh.faces.size(), 0);
  const std::vector<double> inverse_mass(mesh.coordinates.size(), 1.0);
  return contact::join_surface(ranks, mesh, excluded, inverse_mass);
}

struct Counts {
  GlobalIndex sides = 0, facets_of_edges = 0, ends = 0;
};

Counts count(const comm::Communicator& ranks, const contact::Surface& surface) {
  Counts found;
  for (const contact::SurfaceFace& face : surface.faces) found.sides += std::popcount(face.seams);
  for (const contact::SurfaceEdge& edge : surface.edges) found.facets_of_edges += std::ranges::count(edge.seam, true);
  for (const contact::SurfaceEdge& edge : surface.edges)
    for (const std::array<bool, 2>& end : edge.end_at_side) {
      found.ends += end[0] || end[1] ? 1 : 0;
      if (edge.kind == contact::EdgeKind::flat) CHECK(end[0] == end[1]);
      if (edge.kind == contact::EdgeKind::sharp) CHECK_FALSE((end[0] && end[1]));
    }
  return {ranks.sum(found.sides), ranks.sum(found.facets_of_edges), ranks.sum(found.ends)};
}

}  // namespace

TEST_CASE("seams: sides, edges and ends of edges between flush boxes of unequal meshes, of all ranks") {
  const comm::Communicator ranks = comm::Communicator::world();
  const contact::Surface surface = boxes(ranks, 0);
  const Counts found = count(ranks, surface);
  CHECK(surface.flush == std::vector<contact::BodyPair>{{0, 1}});
  CHECK(found.sides == 8 + 10);  // above, below and on both sides: 2 + 2 + 2 + 2 faces of the one, 4 + 4 + 1 + 1
  CHECK(found.facets_of_edges == 8 + 10);
  CHECK(found.ends == 4 + 2 * 3 + 4 * 2 * 2);  // of flat edges in the faces that look at each other, and of their rims
  for (const contact::SurfaceEdge& edge : surface.edges) CHECK_FALSE((edge.seam[0] && edge.seam[1]));
}

TEST_CASE("seams: where one box stands higher by a tenth, its sides alone go on") {
  const comm::Communicator ranks = comm::Communicator::world();
  const contact::Surface surface = boxes(ranks, 0.1);
  CHECK(count(ranks, surface).sides == 4 + 2);
}
