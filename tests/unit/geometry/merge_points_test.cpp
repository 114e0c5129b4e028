// SPDX-License-Identifier: Apache-2.0
// Points that are nearly equal, in any order.
#include "geometry/triangles/merge_points.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "support/surface_samples.hpp"

using namespace brunt;
using geometry::merge_points;
using geometry::MergedSurface;

namespace {

/// Every triangle with three points of its own, as STL has it; each moved by up to `noise`.
TriangleSurface loose(const TriangleSurface& surface, double noise) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(-noise, noise);
  TriangleSurface result;
  for (const auto& triangle : surface.triangles) {
    for (const LocalIndex corner : triangle)
      result.points.push_back(surface.points[static_cast<std::size_t>(corner)] +
                              Vec3(step(random), step(random), step(random)));
    const auto end = static_cast<LocalIndex>(result.points.size());
    result.triangles.push_back({end - 3, end - 2, end - 1});
  }
  return result;
}

TriangleSurface points_alone(std::vector<Vec3> points) {
  return {std::move(points), {}};
}

/// The least index of the points that are within `tolerance` of each other by a chain, pair by pair.
std::vector<std::size_t> brute_force(const std::vector<Vec3>& x, double tolerance) {
  std::vector<std::size_t> group(x.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        if ((x[i] - x[j]).squaredNorm() <= tolerance * tolerance && group[j] < group[i]) {
          group[i] = group[j];
          changed = true;
        }
  }
  return group;
}

}  // namespace

TEST_CASE("The corners of a box come back from loose triangles, exact or with noise below the tolerance") {
  const TriangleSurface box = test::fans_of(test::box_surface({-1, 0, 2}, {1, 3, 5}));
  for (const double noise : {0., 1e-8}) {
    const MergedSurface merged = merge_points(loose(box, noise), 4e-8);
    CHECK(merged.surface.points.size() == 8);
    CHECK(merged.surface.triangles.size() == 12);
    CHECK(merged.merged_points == 28);
    CHECK(merged.dropped_triangles == 0);
    CHECK(merged.largest_distance <= 4e-8);
  }
  CHECK(merge_points(loose(box, 0), 0).surface.points.size() == 8);
  CHECK(merge_points(loose(box, 1e-8), 0).surface.points.size() == 36);
}

TEST_CASE("A chain of points becomes one; its first point in space stands for it, whatever the order") {
  std::vector<Vec3> chain;
  for (int k = 0; k < 100; ++k) chain.emplace_back(0.9e-3 * k, 1e-4 * (k % 2), 0);
  std::mt19937 random(1);
  for (int trial = 0; trial < 5; ++trial) {
    const MergedSurface merged = merge_points(points_alone(chain), 1e-3);
    REQUIRE(merged.surface.points.size() == 1);
    CHECK(merged.surface.points[0] == Vec3(0, 0, 0));
    CHECK(merged.merged_points == 99);
    CHECK(merged.largest_distance == Approx(99 * 0.9e-3).epsilon(1e-4));
    std::shuffle(chain.begin(), chain.end(), random);
  }
  CHECK(merge_points(points_alone(chain), 0.8e-3).surface.points.size() == 100);
}

TEST_CASE("Triangles that lose a corner are dropped and counted") {
  TriangleSurface surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + 1e-7, 0, 0}, {5, 5, 5}};
  surface.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 3, 2}};
  const MergedSurface merged = merge_points(surface, 1e-6);
  CHECK(merged.dropped_triangles == 1);
  CHECK(merged.surface.triangles == std::vector<std::array<LocalIndex, 3>>{{0, 1, 2}, {0, 1, 2}});
  CHECK(merged.surface.points == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}});
}

TEST_CASE("Random points are grouped as by comparing all pairs, at any place") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double origin : {0., 1e3})
    for (const double tolerance : {0.01, 0.1, 0.2}) {
      std::vector<Vec3> x;
      for (int k = 0; k < 400; ++k) x.emplace_back(origin + unit(random), unit(random), unit(random));
      const auto group = brute_force(x, tolerance);
      std::size_t groups = 0;
      for (std::size_t i = 0; i < x.size(); ++i) groups += group[i] == i ? 1 : 0;
      CHECK(merge_points(points_alone(x), tolerance).surface.points.size() == groups);
    }
}

TEST_CASE("Default tolerances: a ratio of the diagonal, and rounding far from the origin") {
  const TriangleSurface near = points_alone({{0, 0, 0}, {2, 3, 6}});
  CHECK(geometry::default_tolerance(near, true) == Approx(7e-6).epsilon(1e-12));
  CHECK(geometry::default_tolerance(near, false) == Approx(7e-9).epsilon(1e-12));
  const TriangleSurface far = points_alone({{1e6, 0, 0}, {1e6 + 1, 0, 0}});
  CHECK(geometry::default_tolerance(far, true) == Approx(4 * 1e6 / 16777216).epsilon(1e-5));
  CHECK(geometry::default_tolerance(far, false) == Approx(1e-9).epsilon(1e-5));
  CHECK(geometry::default_tolerance({}, true) == 0);
}

TEST_CASE("A tolerance far too large ends soon, and leaves one point") {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vec3> x;
  for (int k = 0; k < 50'000; ++k) x.emplace_back(unit(random), unit(random), unit(random));
  CHECK(merge_points(points_alone(x), 0.9).surface.points.size() == 1);
}
