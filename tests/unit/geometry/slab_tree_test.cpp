// SPDX-License-Identifier: Apache-2.0
// Queries of two surfaces against all pairs of triangles: the same pairs, the same doubles.
#include "geometry/triangles/slab_tree.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "shots.hpp"
#include "support/allocations.hpp"
#include "support/depth_bodies.hpp"

using namespace brunt;
using namespace brunt::geometry;
using brunt::geometry::testing::Random;
using brunt::geometry::testing::random_vector;

namespace {

struct Brute {
  bool cross = false;
  double distance = std::numeric_limits<double>::infinity();
  std::vector<NearPair> near;
};

Triangle placed(const Triangle& t, const Placement& placement) {
  return {placement(t[0]), placement(t[1]), placement(t[2])};
}

Brute all_pairs(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double band) {
  Brute brute;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    const Triangle moved = placed(a.triangles[i], a_in_b);
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      brute.cross = brute.cross || triangles_cross(moved, b.triangles[j]);
      const NearestPoints nearest = nearest_points(moved, b.triangles[j], std::max(band, brute.distance));
      brute.distance = std::min(brute.distance, nearest.distance);
      if (nearest.distance < band)
        brute.near.push_back(
            {static_cast<LocalIndex>(i), static_cast<LocalIndex>(j), nearest.distance, nearest.on_a, nearest.on_b});
    }
  }
  return brute;
}

bool same(const std::vector<NearPair>& p, const std::vector<NearPair>& q) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const NearPair& x, const NearPair& y) {
    return x.a == y.a && x.b == y.b && x.distance == y.distance && x.on_a == y.on_a && x.on_b == y.on_b;
  });
}

void check_against_all_pairs(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double band) {
  const Brute brute = all_pairs(a, b, a_in_b, band);
  std::vector<NearPair> near;
  near_pairs(a, b, a_in_b, band, near);
  CHECK(surfaces_cross(a, b, a_in_b) == brute.cross);
  CHECK(same(near, brute.near));
  CHECK(surface_distance(a, b, a_in_b) == brute.distance);
  const double at_most = 0.7 * brute.distance;
  CHECK(surface_distance(a, b, a_in_b, at_most) == at_most);
}

/// A ball with random radii, or a torus with a random tube.
TriangleSurface random_surface(Random& random) {
  std::uniform_real_distribution<double> share(0.6, 1.4);
  if (random() % 2 == 0)
    return test::sphere_grid(9, 7, [&](double u, double s) {
      const double polar = test::pi * s;
      return Vec3(share(random) * Vec3(std::sin(polar) * std::cos(u), std::sin(polar) * std::sin(u), std::cos(polar)));
    });
  return test::torus_grid(12, 6, [&](double u, double w) {
    const double radius = 1 + 0.4 * share(random) * std::cos(w);
    return Vec3(radius * std::cos(u), radius * std::sin(u), 0.4 * share(random) * std::sin(w));
  });
}

TriangleSurface shuffled(const TriangleSurface& surface, Random& random) {
  TriangleSurface result = surface;
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  for (auto& t : result.triangles)
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random() % 3), t.end());
  return result;
}

}  // namespace

TEST_CASE("surfaces at random placements: crossing, near pairs and distance are those of all pairs") {
  Random random(11);
  for (const int directions : {3, 7, 9, 13})
    for (int k = 0; k < 30; ++k) {
      const TriangleSurface first = random_surface(random), second = random_surface(random);
      const SlabTree a = build_slab_tree(first, more_directions(directions));
      const SlabTree b = build_slab_tree(second, more_directions(directions));
      Placement placement = test::random_placement(first, second, random, 1.2);
      if (k % 3 == 0) placement.rotation *= 1 + 1e-9 * (k - 15);  // as products of many rotations are
      check_against_all_pairs(a, b, placement, 0.1);
    }
}

TEST_CASE("the bodies of the reference at random placements agree with all pairs") {
  Random random(12);
  const std::array<std::array<TriangleSurface, 2>, 3> pairs{
      {{test::l_shape(), test::knot()}, {test::pawn(), test::hub()}, {test::mallet(), test::bumpy_sphere()}}};
  for (const auto& [first, second] : pairs) {
    const SlabTree a = build_slab_tree(first), b = build_slab_tree(second);
    const int count = first.triangles.size() < 1000 ? 8 : 2;
    for (int k = 0; k < count; ++k) check_against_all_pairs(a, b, test::random_placement(first, second, random), 0.02);
  }
}

TEST_CASE("boxes that are flush, touch in an edge or a corner, and lie one in another") {
  const SlabTree big = build_slab_tree(test::box(Vec3(-2, -2, -2), Vec3(2, 2, 2)));
  const SlabTree small = build_slab_tree(test::box(Vec3(-.5, -.5, -.5), Vec3(.5, .5, .5)));
  const auto at = [](double x, double y, double z) {
    Placement placement;
    placement.translation = Vec3(x, y, z);
    return placement;
  };
  CHECK(surfaces_cross(small, big, at(2.5, 0, 0)));      // face on face
  CHECK(surfaces_cross(small, big, at(2.5, 2.5, 0)));    // edge on edge
  CHECK(surfaces_cross(small, big, at(2.5, 2.5, 2.5)));  // corner on corner
  CHECK(surfaces_cross(small, big, at(1.5, 0, 0)));      // flush from inside
  CHECK_FALSE(surfaces_cross(small, big, at(2.5 + 1e-15, 0, 0)));
  CHECK_FALSE(surfaces_cross(small, big, at(0, 0, 0)));
  CHECK(surface_distance(small, big, at(0, 0, 0)) == 1.5);
  CHECK(surface_distance(small, big, at(3, 3, 0)) == Approx(std::sqrt(0.5)).epsilon(1e-15));
  CHECK(contains(big, Vec3::Zero()));
  CHECK_FALSE(contains(small, Vec3(1, 0, 0)));
  for (const auto& where : {at(2.5, 0, 0), at(2.5, 2.5, 2.5), at(1.5, 1.5, 0), at(0, 0, 0), at(2.6, 0, 0)})
    check_against_all_pairs(small, big, where, 0.2);
}

TEST_CASE("a surface without triangles, or of one, crosses what it crosses and is infinitely far from nothing") {
  const SlabTree nothing = build_slab_tree({});
  TriangleSurface one;
  one.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  one.triangles = {{0, 1, 2}};
  const SlabTree single = build_slab_tree(one);
  CHECK_FALSE(surfaces_cross(nothing, single, {}));
  CHECK_FALSE(surfaces_cross(single, nothing, {}));
  CHECK(surfaces_cross(single, single, {}));
  CHECK(surface_distance(single, nothing, {}, 3) == 3);
  CHECK(point_depth(nothing, Vec3::Zero()).triangle == no_index);
  CHECK(self_crossings(nothing).count == 0);
  CHECK_THROWS_AS(more_directions(4), std::invalid_argument);
}

TEST_CASE("results follow the numbers of the triangles, not their order, and both bodies may be moved") {
  Random random(13);
  const TriangleSurface first = test::pawn(), second = test::hub();
  const SlabTree a = build_slab_tree(first), b = build_slab_tree(second);
  const SlabTree a_shuffled = build_slab_tree(shuffled(first, random)),
                 b_shuffled = build_slab_tree(shuffled(second, random));
  for (int k = 0; k < 30; ++k) {
    const Placement a_in_b = test::random_placement(first, second, random);
    CHECK(surfaces_cross(a, b, a_in_b) == surfaces_cross(a_shuffled, b_shuffled, a_in_b));
    std::vector<NearPair> near, near_shuffled;
    near_pairs(a, b, a_in_b, 0.05, near);
    near_pairs(a_shuffled, b_shuffled, a_in_b, 0.05, near_shuffled);
    CHECK(near.size() == near_shuffled.size());
    const double distance = surface_distance(a, b, a_in_b);
    CHECK(surface_distance(a_shuffled, b_shuffled, a_in_b) == Approx(distance).margin(1e-13));
    // the other way round
    const Placement b_in_a{a_in_b.rotation.transpose(), a_in_b.rotation.transpose() * -a_in_b.translation};
    CHECK(surface_distance(b, a, b_in_a) == Approx(distance).margin(1e-12));
    CHECK(surfaces_cross(b, a, b_in_a) == surfaces_cross(a, b, a_in_b));
    // file coordinates of a moved
    const Placement moved{test::uniform_rotation(random), random_vector(random, 5)};
    TriangleSurface elsewhere = first;
    for (Vec3& p : elsewhere.points) p = moved(p);
    const Placement back{a_in_b.rotation * moved.rotation.transpose(),
                         a_in_b.translation - a_in_b.rotation * moved.rotation.transpose() * moved.translation};
    CHECK(surface_distance(build_slab_tree(elsewhere), b, back) == Approx(distance).margin(1e-12));
  }
}

TEST_CASE("queries allocate nothing once their output has room") {
  Random random(14);
  const TriangleSurface first = test::pawn(), second = test::hub();
  const SlabTree a = build_slab_tree(first), b = build_slab_tree(second);
  const Placement a_in_b = test::random_placement(first, second, random, 0.3);
  std::vector<NearPair> near;
  near_pairs(a, b, a_in_b, 0.05, near);
  REQUIRE(near.size() > 10);
  const long before = test::allocations;
  near_pairs(a, b, a_in_b, 0.05, near);
  const bool cross = surfaces_cross(a, b, a_in_b);
  const double distance = surface_distance(a, b, a_in_b), depth = point_depth(b, a_in_b.translation).depth;
  const double above = depth_above(b, a_in_b.translation, 0.01);
  CHECK(test::allocations == before);
  CHECK((distance == 0) == cross);
  CHECK((above == depth || above <= 0.01));
}
