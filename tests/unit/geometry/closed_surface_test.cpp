// SPDX-License-Identifier: Apache-2.0
// Closed surfaces, and one fault of each kind with its count and first place.
#include "geometry/triangles/closed_surface.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>
#include <numeric>
#include <random>

#include "geometry/triangles/merge_points.hpp"
#include "support/surface_samples.hpp"

using namespace brunt;
using geometry::check_closed;
using geometry::SurfaceFaults;
using Lines = std::vector<std::string>;

namespace {

TriangleSurface box(const Vec3& low, const Vec3& high) {
  return test::fans_of(test::box_surface(low, high));
}

TriangleSurface cube(double half) {
  return box(Vec3::Constant(-half), Vec3::Constant(half));
}

TriangleSurface reversed(TriangleSurface surface) {
  for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  return surface;
}

TriangleSurface together(const std::vector<TriangleSurface>& surfaces) {
  TriangleSurface all;
  for (const TriangleSurface& surface : surfaces) {
    const auto first = static_cast<LocalIndex>(all.points.size());
    all.points.insert(all.points.end(), surface.points.begin(), surface.points.end());
    for (const auto& [a, b, c] : surface.triangles) all.triangles.push_back({a + first, b + first, c + first});
  }
  return all;
}

Lines lines_of(const TriangleSurface& surface) {
  return describe(check_closed(surface), surface, "a.stl");
}

}  // namespace

TEST_CASE("A box is sound, and has its volume anywhere") {
  for (const double origin : {0., 1e8}) {
    const TriangleSurface surface = box({origin, 0, 0}, {origin + 2, 3, 4});
    const SurfaceFaults faults = check_closed(surface);
    CHECK(faults.sound());
    CHECK(faults.unused_points == 0);
    REQUIRE(faults.shells.size() == 1);
    CHECK(faults.shells[0].triangles == 12);
    CHECK(faults.volume == Approx(24).epsilon(1e-14));
    CHECK(lines_of(surface).empty());
  }
}

TEST_CASE("A missing triangle leaves three open edges") {
  TriangleSurface surface = cube(1);
  surface.triangles.erase(surface.triangles.begin() + 1);
  surface.points.emplace_back(9, 9, 9);
  const SurfaceFaults faults = check_closed(surface);
  CHECK(faults.open.count == 3);
  CHECK(faults.unused_points == 1);
  CHECK(lines_of(surface) == Lines{"a.stl: invalid surface: 3 open edges, the first from (1, 1, -1) to (-1, -1, -1); "
                                   "expected a closed surface"});
}

TEST_CASE("A turned triangle runs along its three edges as its neighbours do") {
  TriangleSurface surface = cube(1);
  std::swap(surface.triangles[5][0], surface.triangles[5][1]);
  CHECK(check_closed(surface).reversed.count == 3);
  CHECK(lines_of(surface) ==
        Lines{"a.stl: invalid surface: 3 edges that two triangles traverse in the same direction, the first from "
              "(-1, -1, 1) to (1, -1, 1); expected no reversed triangles"});
}

TEST_CASE("A fin makes an edge of three triangles and two open ones") {
  TriangleSurface surface = cube(1);
  surface.points.emplace_back(0, -3, 0);
  surface.triangles.push_back({0, 1, 8});
  const SurfaceFaults faults = check_closed(surface);
  CHECK(faults.open.count == 2);
  CHECK(faults.non_manifold.count == 1);
  CHECK(faults.reversed.count == 0);
  CHECK(
      lines_of(surface) ==
      Lines{"a.stl: invalid surface: 2 open edges, the first from (1, -1, -1) to (0, -3, 0); expected a closed surface",
            "a.stl: invalid surface: 1 edge of more than two triangles, the first from (1, -1, -1) to (-1, -1, -1); "
            "expected two "
            "triangles at each edge"});
}

TEST_CASE("Triangles without area are counted; slivers of rounding to floats are none") {
  TriangleSurface surface = cube(1);  // the edge from 0 to 1 with a point in its middle, and a triangle along it
  surface.points.emplace_back(0, -1, -1);
  surface.triangles.insert(surface.triangles.begin() + 2, {{0, 1, 8}});
  for (auto& triangle : surface.triangles)
    if (triangle == std::array<LocalIndex, 3>{0, 1, 5}) triangle = {0, 8, 5};
  surface.triangles.push_back({8, 1, 5});
  CHECK(check_closed(surface).no_area.count == 1);
  CHECK(lines_of(surface) ==
        Lines{"a.stl: invalid surface: 1 triangle without area, the first is number 3 at (-1, -1, -1); expected none"});
  surface.points[8][1] -= 1e-7;
  CHECK(check_closed(surface).sound());
}

TEST_CASE("A cavity in a solid, with an island in it, is sound") {
  const TriangleSurface surface = together({reversed(cube(2)), cube(1), cube(3), box({5, 0, 0}, {6, 1, 1})});
  const SurfaceFaults faults = check_closed(surface);
  CHECK(faults.sound());
  REQUIRE(faults.shells.size() == 4);
  CHECK(faults.shells[0].volume == Approx(-64));
  CHECK(faults.volume == Approx(216 - 64 + 8 + 1));
}

TEST_CASE("Shells the wrong way round") {
  CHECK(lines_of(reversed(cube(1))) == Lines{"a.stl: invalid surface: 1 of 1 shell inside out, the first at (-1, -1, "
                                             "-1), of volume -8; expected triangles "
                                             "counter-clockwise seen from outside; all of them may be reversed"});
  CHECK(
      lines_of(together({cube(3), box({5, 0, 0}, {6, 1, 1}), reversed(box({7, 0, 0}, {8, 1, 1}))})) ==
      Lines{
          "a.stl: invalid surface: 1 of 3 shells inside out, the first at (7, 0, 0), of volume -1; expected triangles "
          "counter-clockwise seen from outside"});
  CHECK(lines_of(together({cube(3), cube(2)})) ==
        Lines{"a.stl: invalid surface: 1 of 2 shells inside another one without being a cavity, the first at (-2, -2, "
              "-2), of volume 64; "
              "expected cavities of reversed triangles"});
  CHECK(lines_of(reversed(together({cube(3), reversed(cube(2))}))).size() == 1);
  // an island inside out in a cavity
  CHECK(check_closed(together({cube(3), reversed(cube(2)), reversed(cube(1))})).inside_out.count == 1);
}

TEST_CASE("Boxes that touch: in an edge they are no manifold, in a point or a face of other triangles they are sound") {
  const auto merged = [](const Vec3& low) {
    return geometry::merge_points(together({box({0, 0, 0}, {1, 1, 1}), box(low, low + Vec3(1, 1, 1))}), 1e-9).surface;
  };
  CHECK(check_closed(merged({1, 1, 0})).non_manifold.count == 1);
  CHECK(check_closed(merged({1, 1, 1})).sound());
  CHECK(check_closed(merged({1, 0.25, 0.25})).sound());
  CHECK(check_closed(merged({1, 0, 0})).non_manifold.count > 0);
}

TEST_CASE("Counts and volumes do not depend on the order of points and triangles") {
  TriangleSurface surface = together({cube(3), reversed(cube(2)), cube(1), reversed(box({7, 0, 0}, {8, 1, 1}))});
  surface.triangles.push_back({0, 1, 2});
  surface.triangles.erase(surface.triangles.begin() + 30);
  std::swap(surface.triangles[17][0], surface.triangles[17][1]);
  const SurfaceFaults reference = check_closed(surface);
  std::mt19937 random(11);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<LocalIndex> order(surface.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    TriangleSurface other{std::vector<Vec3>(order.size()), surface.triangles};
    for (std::size_t i = 0; i < order.size(); ++i) other.points[static_cast<std::size_t>(order[i])] = surface.points[i];
    for (auto& triangle : other.triangles)
      for (LocalIndex& corner : triangle) corner = order[static_cast<std::size_t>(corner)];
    CHECK(check_closed(other).open.triangle == reference.open.triangle);
    std::shuffle(other.triangles.begin(), other.triangles.end(), random);
    const SurfaceFaults faults = check_closed(other);
    CHECK(faults.open.count == reference.open.count);
    CHECK(faults.non_manifold.count == reference.non_manifold.count);
    CHECK(faults.reversed.count == reference.reversed.count);
    CHECK(faults.shells.size() == reference.shells.size());
  }
}
