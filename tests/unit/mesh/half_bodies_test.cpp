// SPDX-License-Identifier: Apache-2.0
// Halves and quarters of round bodies: exactly so much of the whole, cut planes that are plane, sets of them.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/round_bodies.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using namespace brunt::mesh;

namespace {

const std::vector<Half> in_section{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},   {0, -1, 0},
                                   {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};

const Vec3& at(const Mesh& mesh, LocalIndex node) {
  return mesh.coordinates[static_cast<std::size_t>(node)];
}

/// Smallest triple product of the edges at a corner over the product of their lengths.
double worst_shape(const Mesh& mesh) {
  constexpr std::array<std::array<int, 4>, 8> edges{
      {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7}, {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}}};
  double worst = 1;
  for (LocalIndex e = 0; e < mesh.blocks[0].count(); ++e)
    for (const auto& [corner, a, b, c] : edges) {
      const LocalIndex* nodes = mesh.blocks[0].element(e);
      const auto edge = [&](int to) { return (at(mesh, nodes[to]) - at(mesh, nodes[corner])).normalized(); };
      worst = std::min(worst, edge(a).cross(edge(b)).dot(edge(c)));
    }
  return worst;
}

/// Cut planes: nodes exactly in them, on both sides of no plane, and each exterior face in exactly one set.
void require_half(const Mesh& mesh, const Half& half, const std::vector<std::string>& outside) {
  const CheckReport report = check(mesh);
  REQUIRE(report.faults.empty());
  REQUIRE(report.warnings.empty());
  std::size_t sides = 0;
  for (const std::string& set : outside) sides += mesh.side_sets.at("b_" + set).size();
  for (int i = 0; i < 3; ++i) {
    const int kept = half[static_cast<std::size_t>(i)];
    const std::string low = std::string("b_") + "xyz"[i] + "min", high = std::string("b_") + "xyz"[i] + "max";
    CHECK(mesh.node_sets.contains(low) == (kept > 0));
    CHECK(mesh.node_sets.contains(high) == (kept < 0));
    if (kept == 0) continue;
    const std::string name = kept > 0 ? low : high;
    std::size_t in_plane = 0;
    for (const Vec3& x : mesh.coordinates) {
      CHECK(kept * x[i] >= 0);
      in_plane += x[i] == 0 ? 1 : 0;
    }
    CHECK(mesh.node_sets.at(name).size() == in_plane);
    for (const LocalIndex n : mesh.node_sets.at(name)) CHECK(at(mesh, n)[i] == 0);
    sides += mesh.side_sets.at(name).size();
  }
  CHECK(sides == exterior_sides(mesh).size());
}

double share(const Half& half) {
  double kept = 1;
  for (const int one : half) kept *= one == 0 ? 1 : 0.5;
  return kept;
}

}  // namespace

TEST_CASE("a half or quarter cylinder is so much of the whole", "[half]") {
  for (const int across : {2, 3, 5, 8})
    for (const int along : {1, 4})
      for (const Half& half : in_section) {
        INFO(across << " across, half " << half[0] << ' ' << half[1]);
        const Mesh whole = cylinder("b", 1.7, 3, {across, along}), part = cylinder("b", 1.7, 3, {across, along}, half);
        require_half(part, half, {"bottom", "top", "side"});
        CHECK(part.blocks[0].count() == share(half) * whole.blocks[0].count());
        CHECK(moments(part).volume == Approx(share(half) * moments(whole).volume).epsilon(1e-14));
        CHECK(worst_shape(part) >= worst_shape(whole));
        for (const LocalIndex n : part.node_sets.at("b_side"))
          CHECK(at(part, n).head<2>().norm() == Approx(1.7).epsilon(1e-14));
      }
}

TEST_CASE("a half or quarter tube is so much of the whole", "[half]") {
  for (const int through : {1, 3})
    for (const int around : {4, 6, 8, 10, 12, 36})
      for (const Half& half : in_section) {
        const bool quarter = half[0] != 0 && half[1] != 0;
        INFO(around << " around, half " << half[0] << ' ' << half[1]);
        if (quarter && around % 4 != 0) {
          CHECK_THROWS_WITH(tube("b", 1, 2, 3, {through, around, 2}, half),
                            Catch::Contains("expected a multiple of 4"));
          continue;
        }
        const Mesh whole = tube("b", 1, 2, 3, {through, around, 2}),
                   part = tube("b", 1, 2, 3, {through, around, 2}, half);
        require_half(part, half, {"bottom", "top", "side", "inner"});
        CHECK(part.blocks[0].count() == share(half) * whole.blocks[0].count());
        CHECK(moments(part).volume == Approx(share(half) * moments(whole).volume).epsilon(1e-14));
        CHECK(worst_shape(part) == Approx(worst_shape(whole)).epsilon(1e-12));
        if (around % 4 != 0) continue;  // else the nodes are those of the whole, to the last bit
        for (const Vec3& x : part.coordinates)
          CHECK(std::ranges::any_of(whole.coordinates, [&](const Vec3& y) { return x == y; }));
      }
  for (const int around : {3, 5, 7, 9})
    CHECK_THROWS_WITH(tube("b", 1, 2, 3, {1, around, 2}, {0, -1, 0}), Catch::Contains("expected a multiple of 2"));
  CHECK_THROWS_WITH(tube("b", 1, 2, 3, {1, 8, 2}, {0, 0, 1}), Catch::Contains("expected x, y"));
  CHECK_THROWS_WITH(cylinder("b", 1, 2, {3, 2}, {1, 0, -1}), Catch::Contains("expected x, y"));
}

TEST_CASE("a tube is mirrored exactly at both axes", "[half]") {
  const Mesh mesh = tube("b", 1, 2, 3, {2, 20, 1});
  for (const Vec3& x : mesh.coordinates)
    for (const Vec3& image : {Vec3(-x[0], x[1], x[2]), Vec3(x[0], -x[1], x[2]), Vec3(x[1], x[0], x[2])})
      CHECK(std::ranges::any_of(mesh.coordinates, [&](const Vec3& y) { return image == y; }));
}

TEST_CASE("either half of a sphere", "[half]") {
  for (const int n : {2, 3, 6})
    for (const int x : {-1, 0, 1})
      for (const int y : {-1, 1})
        for (const int z : {-1, 0, 1}) {
          const Half half{x, y, z};
          const Mesh whole = sphere("b", 2, n), part = sphere("b", 2, n, {.finer = 1, .half = half});
          require_half(part, half, {"surface"});
          CHECK(moments(part).volume == Approx(share(half) * moments(whole).volume).epsilon(1e-13));
        }
}

TEST_CASE("half a graded sphere keeps its fine pole and a plane", "[half]") {
  for (const int n : {4, 7, 12})
    for (const double finer : {1.0, 2.0, 8.0, 30.0})
      for (const Half& half : {Half{0, 0, -1}, Half{1, 0, -1}, Half{-1, 1, -1}}) {
        INFO(n << " across, finer " << finer);
        const Mesh part = sphere("b", 2, n, {.finer = finer, .half = half});
        const Mesh even = sphere("b", 2, n, {.finer = 1, .half = half});
        require_half(part, half, {"surface"});
        CHECK(part.blocks[0].nodes == even.blocks[0].nodes);
        for (const LocalIndex node : part.node_sets.at("b_surface"))
          CHECK(at(part, node).norm() == Approx(2).epsilon(1e-14));
        CHECK(moments(part).volume > (n == 4 ? 0.85 : 0.95) * moments(even).volume);
        // the edges at the pole, compared with those of the even half
        const auto pole = [](const Mesh& mesh) {
          LocalIndex lowest = 0;
          for (const LocalIndex node : mesh.node_sets.at("b_surface"))
            if (at(mesh, node)[2] < at(mesh, lowest)[2]) lowest = node;
          double shortest = 1e9;
          for (const LocalIndex node : mesh.node_sets.at("b_surface"))
            if (node != lowest) shortest = std::min(shortest, (at(mesh, node) - at(mesh, lowest)).norm());
          return shortest;
        };
        CHECK(pole(even) / pole(part) <= finer * 1.001);
        CHECK(pole(even) / pole(part) > (n == 12 ? 0.75 : 0.3) * finer);
      }
  CHECK_THROWS_WITH(sphere("b", 2, 4, {.finer = 2, .half = {0, 0, 1}}), Catch::Contains("expected -z"));
}

TEST_CASE("volume and centre of meshes converge to those of the exact bodies", "[half]") {
  const double pi = std::numbers::pi;
  CHECK(exact_sphere(2, {}).volume == Approx(32 * pi / 3));
  CHECK(exact_tube(0, 2, 5, {1, -1, 0}).volume == Approx(5 * pi));
  for (const Half& half : {Half{}, Half{1, 0, 0}, Half{0, -1, 0}, Half{-1, 1, 0}}) {
    const auto error = [&](const Moments& found, const Moments& exact) {
      return std::array{1 - found.volume / exact.volume, (found.centre - exact.centre).norm()};
    };
    const auto of = [&](int n) {
      return std::array{error(moments(sphere("s", 2, n, {.finer = 1, .half = half})), exact_sphere(2, half)),
                        error(moments(cylinder("c", 2, 5, {n, 2}, half)), exact_tube(0, 2, 5, half)),
                        error(moments(tube("t", 1, 2, 5, {1, 4 * n, 2}, half)), exact_tube(1, 2, 5, half))};
    };
    const auto coarse = of(10), fine = of(20);
    for (std::size_t body = 0; body < 3; ++body) {
      INFO("body " << body);
      CHECK(coarse[body][0] / fine[body][0] == Approx(4).epsilon(0.06));
      CHECK(fine[body][0] < 0.005);
      CHECK(fine[body][1] < 0.005);
    }
  }
  // a box has no error at all
  const Moments exact = moments(box("b", {1, 2, 3}, {2, 1, 3}));
  CHECK(exact.volume == Approx(6).epsilon(1e-14));
  CHECK((exact.centre - Vec3(0.5, 1, 1.5)).norm() < 1e-14);
}
