// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/thickness.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "brunt/mesh/primitives.hpp"
#include "brunt/mesh/topology.hpp"

using namespace brunt;
using contact::FacetNodes;

namespace {

struct Surface {
  std::vector<FacetNodes> facets;
  std::vector<Vec3> x;

  explicit Surface(const mesh::Mesh& mesh) : x(mesh.coordinates.begin(), mesh.coordinates.end()) {
    for (const mesh::Side& side : mesh::exterior_sides(mesh)) {
      const mesh::Block& block = mesh.blocks[static_cast<std::size_t>(side.block)];
      const auto nodes = mesh::face_nodes(block.shape, block.element(side.element), side.face);
      facets.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
    }
  }
};

}  // namespace

TEST_CASE("a plate has its thickness behind both faces, and nothing within reach behind its rim") {
  const Surface plate(mesh::box("p", {4, 3, 0.25}, {8, 6, 1}));
  const std::vector<double> wall = implicit::thickness_behind(plate.facets, plate.x, 1);
  for (std::size_t f = 0; f < wall.size(); ++f) {
    const auto z = [&](int k) {
      return plate.x[static_cast<std::size_t>(plate.facets[f][static_cast<std::size_t>(k)])][2];
    };
    if (z(0) == z(1) && z(1) == z(2))
      CHECK(wall[f] == Approx(0.25).epsilon(1e-12));
    else
      CHECK(std::isinf(wall[f]));
  }
}

TEST_CASE("a hollow torus is as thick as its wall, from outside and from inside") {
  const Surface torus(mesh::torus("t", 76, 20, 24, {40, 20, 1}));
  const std::vector<double> wall = implicit::thickness_behind(torus.facets, torus.x, 12);
  for (const double thickness : wall) {
    CHECK(thickness > 0.9 * 4);  // facets are chords: the middle of one lies nearer to the other side
    CHECK(thickness < 1.05 * 4);
  }
}

TEST_CASE("edges are compared where two surfaces meet") {
  Surface both(mesh::box("fine", {1, 1, 1}, {8, 8, 4})), coarse(mesh::box("coarse", {1, 1, 1}, {2, 2, 8}));
  const auto first = static_cast<LocalIndex>(both.x.size());
  for (const Vec3& x : coarse.x) both.x.push_back(x + Vec3(0, 0, 1.1));
  for (FacetNodes& facet : coarse.facets)
    for (LocalIndex& node : facet) node += first;
  const implicit::SeatEdges seat = implicit::edges_at_seat(both.facets, coarse.facets, both.x, 0.5);
  CHECK(seat.area == Approx(1));
  CHECK(seat.slave == Approx(1.0 / 8));
  CHECK(seat.master == Approx(1.0 / 2));
  CHECK(implicit::edges_at_seat(both.facets, coarse.facets, both.x, 0.05).area == 0);
}

TEST_CASE("a body that is thicker than the reach has no walls, and neither has no body") {
  const Surface block(mesh::box("b", {4, 4, 4}, {2, 2, 2}));
  for (const double thickness : implicit::thickness_behind(block.facets, block.x, 2)) CHECK(std::isinf(thickness));
  CHECK(implicit::thickness_behind({}, {}, 1).empty());
}
