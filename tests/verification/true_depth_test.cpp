// SPDX-License-Identifier: Apache-2.0
// The measure that random impacts are judged by, against depths by hand and against dense points on the surface.
#include "support/true_depth.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"
#include "support/tetrahedra.hpp"

using namespace brunt;
using test::Solid;

namespace {

/// Nearest of 200 x 200 points on each exterior face [length].
double by_dense_points(const mesh::Mesh& mesh, const Vec3& point) {
  constexpr int parts = 200;
  double nearest = 1e300;
  for (const mesh::Side& side : mesh::exterior_sides(mesh)) {
    const mesh::Block& block = mesh.blocks[0];
    const auto nodes = mesh::face_nodes(block.shape, block.element(side.element), side.face);
    const auto x = [&](std::size_t k) { return mesh.coordinates[static_cast<std::size_t>(nodes[k])]; };
    const Vec3 a = x(0), b = x(1), c = x(2), d = nodes[3] == no_index ? x(2) : x(3);
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; j <= parts; ++j) {
        const double r = static_cast<double>(i) / parts, s = static_cast<double>(j) / parts;
        const Vec3 on = (1 - r) * (1 - s) * a + r * (1 - s) * b + r * s * c + (1 - r) * s * d;
        nearest = std::min(nearest, (on - point).norm());
      }
  }
  return nearest;
}

mesh::Mesh warped(bool tets) {
  mesh::Mesh mesh = mesh::box("b", {1, 1, 1}, {2, 2, 2});
  for (Vec3& x : mesh.coordinates)
    x = Vec3(x[0] + 0.1 * x[1] * x[2], x[1] + 0.2 * x[0] * x[0], x[2] * (1 + 0.3 * x[0] * x[1]));
  return tets ? test::in_tetrahedra(std::move(mesh)) : mesh;
}

}  // namespace

TEST_CASE("true depth: of points in a cube the least distance to a side, outside of it nothing", "[oracle]") {
  for (const bool tets : {false, true}) {
    mesh::Mesh mesh = mesh::box("b", {1, 1, 1}, {3, 3, 3});
    if (tets) mesh = test::in_tetrahedra(std::move(mesh));
    const Solid cube(mesh, 0);
    CAPTURE(tets);
    CHECK(cube.depth({0.4, 0.45, 0.9}).depth == Approx(0.1).epsilon(1e-8));
    CHECK(cube.depth({0.02, 0.03, 0.97}).depth == Approx(0.02).epsilon(1e-7));
    CHECK(cube.depth({0.5, 0.5, 0.5}).depth == Approx(0.5).epsilon(1e-8));
    CHECK(cube.depth({0.5, 0.5, 1 - 1e-7}).depth == Approx(1e-7).epsilon(1e-3));
    CHECK((cube.depth({0.4, 0.45, 0.9}).nearest - Vec3(0.4, 0.45, 1)).norm() < 1e-7);
    for (const Vec3& out : {Vec3(0.5, 0.5, 1.001), Vec3(-1e-6, 0.5, 0.5), Vec3(2, 0, 0)})
      CHECK(cube.depth(out).depth == 0);
    if (!tets) CHECK(cube.depth({0.4, 0.45, 0.9}).edge == Approx(1.0 / 3).epsilon(1e-12));
  }
}

TEST_CASE("true depth: of points in warped elements as dense points on their surface say", "[oracle]") {
  for (const bool tets : {false, true}) {
    const mesh::Mesh mesh = warped(tets);
    const Solid body(mesh, 0);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-0.1, 1.4);
    int inside = 0;
    for (int k = 0; k < 60; ++k) {
      const Vec3 point(any(random), any(random), any(random));
      const double depth = body.depth(point).depth;
      if (depth == 0) continue;
      ++inside;
      CAPTURE(tets, point.transpose());
      const double dense = by_dense_points(mesh, point);
      CHECK(depth <= dense * (1 + 1e-9));
      CHECK(depth >= dense - 0.004 * 0.004 / std::max(dense, 0.004) - 1e-6);  // their spacing is 0.5 to 0.8 of 0.005
    }
    CHECK(inside >= 15);
  }
}

TEST_CASE("true depth: an edge may be deep where no node is", "[oracle]") {
  mesh::Mesh mesh = mesh::box("one", {1, 1, 1}, {1, 1, 1}), bar = mesh::box("two", {3, 1, 1}, {1, 1, 1});
  mesh::place(bar, 1, {1, 0, 0}, 45, {-1, 0.5, 0.95});  // its lower edge is 0.05 below the top of the cube
  mesh::append(mesh, std::move(bar));
  const Solid one(mesh, 0), two(mesh, 1);
  CHECK(test::deepest_node(two, one).depth == 0);
  CHECK(test::deepest_node(one, two).depth == 0);
  CHECK(test::deepest_on_edges(two, one).depth == Approx(0.05).epsilon(1e-6));
}
