// SPDX-License-Identifier: Apache-2.0
// A rod through a plate: no node of either is inside the other.
#include "setup/piercings.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"

using namespace brunt;

namespace {

/// A plate of one element, 1 x 1 x 0.1, and a rod of one element, 0.1 x 0.1 x 2, from z = `start` on.
mesh::Mesh plate_and_rod(double start) {
  mesh::Mesh mesh = mesh::box("plate", {1, 1, 0.1}, {1, 1, 1});
  mesh::Mesh rod = mesh::box("rod", {0.1, 0.1, 2}, {1, 1, 1});
  mesh::place(rod, 1, {0, 0, 1}, 0, {0.3, 0.4, start});
  mesh::append(mesh, std::move(rod));
  return mesh;
}

std::vector<setup::PiercingEdge> pierce(double start, std::vector<char> inside = std::vector<char>(16, 0)) {
  const mesh::Mesh mesh = plate_and_rod(start);
  const std::vector<setup::Solid> solids = setup::solids_of(mesh);
  CHECK(setup::piercing_edges(mesh, solids[0], solids[1], inside).empty());  // the plate's edges are far from the rod
  return setup::piercing_edges(mesh, solids[1], solids[0], inside);
}

}  // namespace

TEST_CASE("piercings: the four long edges of a rod through a plate, each once") {
  const std::vector<setup::PiercingEdge> found = pierce(-1);
  REQUIRE(found.size() == 4);
  const mesh::Mesh mesh = plate_and_rod(-1);
  for (const setup::PiercingEdge& edge : found) {
    const Vec3 along = mesh.coordinates[static_cast<std::size_t>(edge.edge[1])] -
                       mesh.coordinates[static_cast<std::size_t>(edge.edge[0])];
    CHECK(std::abs(along.z()) == 2);
  }
}

TEST_CASE("piercings: none where the rod ends on the plate or before it, nor of edges with a node inside") {
  CHECK(pierce(0.1).empty());
  CHECK(pierce(0.2).empty());
  CHECK(pierce(-2).empty());
  std::vector<char> inside(16, 0);
  inside[8] = 1;  // a node of the rod: its edge is told by it
  CHECK(pierce(-1, inside).size() == 3);
}
