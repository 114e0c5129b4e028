// SPDX-License-Identifier: Apache-2.0
#include "implicit/mortar/thickness.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"

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

namespace {
/// The surfaces of a box and of another one above it, whose nodes are appended, with the walls behind them as the
/// set-up of contact finds them.
contact::MortarSurfaces above(Surface& low, const Surface& top, double height) {
  contact::MortarSurfaces both;
  both.capture = 0.5;
  both.slave = low.facets;
  both.master = top.facets;
  both.slave_wall = implicit::thickness_behind(both.slave, low.x, both.capture);
  both.master_wall = implicit::thickness_behind(both.master, top.x, both.capture);
  for (FacetNodes& facet : both.master)
    for (LocalIndex& node : facet) node += static_cast<LocalIndex>(low.x.size());
  for (const Vec3& x : top.x) low.x.push_back(x + Vec3(0, 0, height));
  return both;
}
}  // namespace

TEST_CASE("edges are compared where two surfaces touch or overlap, thin or thick") {
  for (const double thick : {1.0, 0.1})
    for (const double gap : {0.0, -0.01, 1e-9}) {
      Surface low(mesh::box("fine", {1, 1, thick}, {8, 8, 1}));
      const Surface top(mesh::box("coarse", {1, 1, thick}, {2, 2, 8}));
      const contact::MortarSurfaces both = above(low, top, thick + gap);
      const implicit::SeatEdges seat = implicit::edges_at_seat(both, low.x, 1e-6);
      CHECK(seat.area == Approx(1));
      CHECK(seat.slave == Approx(1.0 / 8));
      CHECK(seat.master == Approx(1.0 / 2));
    }
}

TEST_CASE("surfaces that are only near each other are no seat") {
  Surface low(mesh::box("fine", {1, 1, 1}, {8, 8, 4}));
  const Surface top(mesh::box("coarse", {1, 1, 1}, {2, 2, 8}));
  const contact::MortarSurfaces both = above(low, top, 1.1);
  CHECK(implicit::edges_at_seat(both, low.x, 1e-6).area == 0);
}

TEST_CASE("a body that is thicker than the reach has no walls, and neither has no body") {
  const Surface block(mesh::box("b", {4, 4, 4}, {2, 2, 2}));
  for (const double thickness : implicit::thickness_behind(block.facets, block.x, 2)) CHECK(std::isinf(thickness));
  CHECK(implicit::thickness_behind({}, {}, 1).empty());
}
