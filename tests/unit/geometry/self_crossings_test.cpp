// SPDX-License-Identifier: Apache-2.0
// Surfaces that cross themselves, and neighbours that only share corners and edges.
#include <catch2/catch.hpp>

#include "geometry/triangles/slab_tree.hpp"
#include "support/depth_bodies.hpp"

using namespace brunt;
using namespace brunt::geometry;

namespace {

TriangleSurface triangles(const std::vector<Triangle>& corners) {
  TriangleSurface surface;
  for (const Triangle& t : corners) {
    const auto first = static_cast<LocalIndex>(surface.points.size());
    surface.points.insert(surface.points.end(), t.begin(), t.end());
    surface.triangles.push_back({first, first + 1, first + 2});
  }
  return surface;
}

std::int64_t crossings(const std::vector<Triangle>& corners) {
  return self_crossings(build_slab_tree(triangles(corners))).count;
}

const Triangle base{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

}  // namespace

TEST_CASE("neighbours that share a corner or an edge do not cross; folded or piercing ones do") {
  CHECK(crossings({base, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(0, -4, 0)}}) == 0);   // an edge, flat
  CHECK(crossings({base, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, 3)}}) == 0);    // an edge, a sharp wedge
  CHECK(crossings({base, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, 0)}}) == 1);    // an edge, folded flat
  CHECK(crossings({base, {Vec3(0, 0, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}}) == 0);  // a corner, flat
  CHECK(crossings({base, {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 1, 1)}}) == 0);    // a corner, above
  CHECK(crossings({base, {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(1, 1, -1)}}) == 1);   // a corner, piercing
  CHECK(crossings({base, {Vec3(0, 0, 0), Vec3(9, 9, 9), Vec3(9, 9, -9)}}) == 1);   // piercing and beyond
  CHECK(crossings({base, {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(-1, 3, 0)}}) == 1);   // a corner, overlapping flat
  CHECK(crossings({base, {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1)}}) == 1);    // a corner, an edge within
  CHECK(crossings({base, base}) == 1);                                             // twice the same
  CHECK(crossings({base, {base[1], base[0], base[2]}}) == 1);                      // and turned over
  CHECK(crossings({base, {Vec3(1, 1, 0), Vec3(1, 1, 2), Vec3(2, 1, 2)}}) == 1);    // touching with a corner
  CHECK(crossings({base, {Vec3(1, 1, -1), Vec3(1, 1, 2), Vec3(2, 1, 2)}}) == 1);   // piercing
  CHECK(crossings({base, {Vec3(1, 1, 1), Vec3(1, 1, 2), Vec3(2, 1, 2)}}) == 0);    // apart
  CHECK(crossings({base, {Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0)}}) == 0);    // a point: left out
}

TEST_CASE("bodies joined into one surface cross where they overlap; the first pair is the least") {
  TriangleSurface both = test::bumpy_sphere();
  const auto shift = static_cast<LocalIndex>(both.points.size());
  const auto first = static_cast<LocalIndex>(both.triangles.size());
  const TriangleSurface other = test::pawn();
  for (const Vec3& p : other.points) both.points.push_back(p + Vec3(1, 0, 0));
  for (const auto& t : other.triangles) both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  const SlabTree tree = build_slab_tree(both);
  SelfCrossings brute;
  for (LocalIndex i = 0; i < first; ++i)
    for (auto j = first; j < static_cast<LocalIndex>(both.triangles.size()); ++j) {
      if (!triangles_cross(tree.triangles[static_cast<std::size_t>(i)], tree.triangles[static_cast<std::size_t>(j)]))
        continue;
      if (brute.count++ == 0) {
        brute.first_a = i;
        brute.first_b = j;
      }
    }
  REQUIRE(brute.count > 10);
  const SelfCrossings found = self_crossings(tree);
  CHECK(found.count == brute.count);
  CHECK(found.first_a == brute.first_a);
  CHECK(found.first_b == brute.first_b);
}
