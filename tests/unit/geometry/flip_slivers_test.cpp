// SPDX-License-Identifier: Apache-2.0
// Triangles without area: replaced where the surface stays the same.
#include "geometry/triangles/flip_slivers.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "geometry/triangles/closed_surface.hpp"
#include "geometry/triangles/slab_tree.hpp"
#include "support/surface_samples.hpp"

using namespace brunt;
using geometry::check_closed;
using geometry::flip_slivers;

namespace {

std::size_t at(LocalIndex i) {
  return static_cast<std::size_t>(i);
}

/// A point in the side of a triangle, for this triangle alone: the neighbour keeps the side, and a triangle without
/// area fills the gap.
void add_sliver(TriangleSurface& surface, std::size_t triangle, std::size_t side, double share) {
  const auto old = surface.triangles[triangle];
  const LocalIndex a = old[side], b = old[(side + 1) % 3], c = old[(side + 2) % 3];
  const auto p = static_cast<LocalIndex>(surface.points.size());
  surface.points.emplace_back((1 - share) * surface.points[at(a)] + share * surface.points[at(b)]);
  surface.triangles[triangle] = {a, p, c};
  surface.triangles.push_back({p, b, c});
  surface.triangles.push_back({a, b, p});
}

}  // namespace

TEST_CASE("a sound surface stays as it is") {
  TriangleSurface surface = test::fans_of(test::box_surface({0, 0, 0}, {1, 2, 3}));
  const auto before = surface.triangles;
  CHECK(flip_slivers(surface) == 0);
  CHECK(surface.triangles == before);
}

TEST_CASE("slivers of random boxes are replaced, and the volume stays") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  for (int count = 1; count <= 12; ++count)
    for (int trial = 0; trial < 20; ++trial) {
      TriangleSurface surface = test::fans_of(test::box_surface({0, 0, 0}, {1, 2, 3}));
      for (int k = 0; k < count; ++k) {
        std::size_t triangle = random() % surface.triangles.size();
        while (!geometry::has_area(surface, surface.triangles[triangle]))
          triangle = random() % surface.triangles.size();
        add_sliver(surface, triangle, random() % 3, share(random));
      }
      std::shuffle(surface.triangles.begin(), surface.triangles.end(), random);
      const auto slivers = check_closed(surface).no_area.count;
      REQUIRE(slivers >= 1);
      CHECK(flip_slivers(surface) >= 1);
      const geometry::SurfaceFaults faults = check_closed(surface);
      INFO(count << " slivers, " << faults.no_area.count << " left");
      CHECK(faults.open.count + faults.non_manifold.count + faults.reversed.count == 0);
      CHECK(faults.no_area.count == 0);
      CHECK(faults.volume == Approx(6).epsilon(1e-12));
    }
}

TEST_CASE("slivers of rounded points are replaced within the tolerance, and points beside them keep their side") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.1, 0.9), error(-1e-6, 1e-6), place(-1.5, 4.5);
  const Vec3 high(1, 2, 3);
  for (int trial = 0; trial < 20; ++trial) {
    TriangleSurface surface = test::fans_of(test::box_surface({0, 0, 0}, high));
    for (int k = 0; k < 3; ++k)
      add_sliver(surface, static_cast<std::size_t>(4 * k) + random() % 4, random() % 3, share(random));
    for (std::size_t i = surface.points.size() - 3; i < surface.points.size(); ++i)
      surface.points[i] += Vec3(error(random), error(random), error(random));
    TriangleSurface healed = surface;
    CHECK(flip_slivers(healed, 2e-6) >= 3);
    const geometry::SurfaceFaults faults = check_closed(healed);
    CHECK(faults.sound());
    CHECK(faults.volume == Approx(6).epsilon(1e-5));
    CHECK(geometry::self_crossings(geometry::build_slab_tree(healed)).count == 0);
    geometry::SlabTree as_given = geometry::build_slab_tree(surface);
    geometry::distrust_crossings(as_given);
    for (int k = 0; k < 300; ++k) {
      const Vec3 x(place(random), place(random), place(random));
      const bool inside = (x.array() > 0).all() && (x.array() < high.array()).all();
      if ((geometry::point_depth(as_given, x).depth > 0) != inside)
        FAIL("x = " << x.transpose() << ", trial " << trial);
    }
  }
}

TEST_CASE("triangles without area that no flip can replace stay") {
  TriangleSurface surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  surface.triangles = {{0, 1, 2}, {0, 2, 1}};  // back to back
  CHECK(flip_slivers(surface) == 0);
  surface.triangles = {{0, 1, 2}};  // open
  CHECK(flip_slivers(surface) == 0);
  CHECK(check_closed(surface).no_area.count == 1);
}
