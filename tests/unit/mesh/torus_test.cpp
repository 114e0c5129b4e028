// SPDX-License-Identifier: Apache-2.0
// Hollow tori: the nodes and volumes of reference-mortar.md M8, closed surfaces, faults.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "body_quality.hpp"
#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/primitives.hpp"
#include "mesh/round_bodies.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using namespace brunt::mesh;
using std::numbers::pi;

namespace {

Mesh torus_of_m8(int around, int through) {
  return torus("t", 76, 19.5, 24, {around, around / 2, through});
}

/// Outward of the tube: away from the circle of the tube's centres.
double outward(const Mesh& mesh, const Side& side) {
  const auto nodes = face_nodes(Shape::hex8, mesh.blocks[0].element(side.element), side.face);
  const auto at = [&](std::size_t i) { return mesh.coordinates[static_cast<std::size_t>(nodes[i])]; };
  const Vec3 middle = 0.25 * (at(0) + at(1) + at(2) + at(3)), area = (at(2) - at(0)).cross(at(3) - at(1));
  Vec3 centre(middle[0], middle[1], 0);
  centre *= 76 / centre.norm();
  return area.normalized().dot((middle - centre).normalized());
}

}  // namespace

TEST_CASE("a torus has the volumes of M8 and elements of positive volume", "[torus]") {
  CHECK(moments(torus_of_m8(40, 2)).volume == Approx(287667.0765).epsilon(1e-9));
  CHECK(moments(torus_of_m8(80, 2)).volume == Approx(292153.4946).epsilon(1e-9));
  CHECK(moments(torus_of_m8(80, 4)).volume < 293660.2094);
  CHECK(exact_torus(76, 19.5, 24).volume == Approx(293660.2094).epsilon(1e-9));
  const Mesh mesh = torus_of_m8(40, 2);
  CHECK(mesh.blocks[0].count() == 1600);
  CHECK(mesh.coordinates.size() == 2400);
  CHECK(moments(mesh).centre.norm() < 1e-10);
  CHECK(check(mesh).faults.empty());
  CHECK(check(mesh).warnings.empty());
  CHECK(worst_shape(mesh) > 0.9);
}

TEST_CASE("nodes of a torus are those of M8", "[torus]") {
  const Mesh mesh = torus_of_m8(40, 2);
  std::size_t node = 0;
  double farthest = 0;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 20; ++j)
      for (int k = 0; k <= 2; ++k) {
        const double u = 2 * pi * i / 40, w = 2 * pi * j / 20, r = 19.5 + 4.5 * k / 2;
        const Vec3 x((76 + r * std::cos(w)) * std::cos(u), (76 + r * std::cos(w)) * std::sin(u), r * std::sin(w));
        farthest = std::max(farthest, (mesh.coordinates[node++] - x).norm());
      }
  CHECK(farthest < 1e-13 * 100);
}

TEST_CASE("the surface of a torus is its two sides, both closed and outward", "[torus]") {
  for (const int around : {8, 20, 40}) {
    const Mesh mesh = torus_of_m8(around, 3);
    const auto& side = mesh.side_sets.at("t_side");
    const auto& inner = mesh.side_sets.at("t_inner");
    const auto facets = static_cast<std::size_t>(around * around / 2);
    CHECK(side.size() == facets);
    CHECK(inner.size() == facets);
    CHECK(exterior_sides(mesh).size() == 2 * facets);
    CHECK(mesh.node_sets.at("t_side").size() == facets);
    std::map<std::pair<LocalIndex, LocalIndex>, int> edges;
    for (const Side& one : exterior_sides(mesh)) {
      const auto nodes = face_nodes(Shape::hex8, mesh.blocks[0].element(one.element), one.face);
      for (std::size_t i = 0; i < 4; ++i) ++edges[{nodes[i], nodes[(i + 1) % 4]}];
    }
    bool closed = true;
    for (const auto& [edge, count] : edges) closed = closed && count == 1 && edges.contains({edge.second, edge.first});
    CHECK(closed);
    for (const Side& one : side) REQUIRE(outward(mesh, one) > 0.8);
    for (const Side& one : inner) REQUIRE(outward(mesh, one) < -0.8);
  }
}

TEST_CASE("the wall of a torus may be graded", "[torus]") {
  Divisions<3> elements(8, 8, 4);
  elements[2].bias = 8;
  const Mesh mesh = torus("t", 76, 20, 24, elements);
  const auto thickness = [&](std::size_t k) { return mesh.coordinates[k + 1][0] - mesh.coordinates[k][0]; };
  CHECK(mesh.coordinates[0][0] == 96);
  CHECK(mesh.coordinates[4][0] == 100);
  CHECK(thickness(3) == Approx(8 * thickness(0)));
  CHECK(check(mesh).faults.empty());
}

TEST_CASE("what is no torus is refused, every fault in a line", "[torus]") {
  const auto faults = [](double radius, double inner, double outer, const Divisions<3>& elements) {
    try {
      torus("t", radius, inner, outer, elements);
    } catch (const InputError& error) {
      return error.faults();
    }
    return std::vector<std::string>{};
  };
  CHECK(faults(76, 20, 24, {3, 3, 1}).empty());
  CHECK(faults(76, 24, 20, {4, 4, 1}) ==
        std::vector<std::string>{
            "torus t: out of range: the inner radius 24 of the tube; expected less than its outer radius 20"});
  CHECK(faults(24, 20, 24, {4, 4, 1}) ==
        std::vector<std::string>{
            "torus t: out of range: radius is 24; expected more than the outer radius 24 of the tube"});
  CHECK(faults(76, 0, 24, {2, 2, 0}).size() == 4);
  CHECK(faults(76, 20, 24, {100000, 100000, 9}).size() == 1);
}
