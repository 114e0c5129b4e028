// SPDX-License-Identifier: Apache-2.0
// Depths of points below closed surfaces: distances against all triangles, signs against solid angles.
#include <catch2/catch.hpp>

#include "geometry/triangles/slab_tree.hpp"
#include "shots.hpp"
#include "support/depth_bodies.hpp"

using namespace brunt;
using namespace brunt::geometry;
using brunt::geometry::testing::between;
using brunt::geometry::testing::Random;
using brunt::geometry::testing::random_vector;

namespace {

double brute_distance(const SlabTree& tree, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : tree.triangles) least = std::min(least, nearest_points({x, x, x}, t).distance);
  return least;
}

/// Of the depth at `x`: the distance, the sign, the nearest point, and what the other queries say of it.
void check_depth(const SlabTree& tree, const Vec3& x, Random& random) {
  const double distance = brute_distance(tree, x), winding = winding_number(tree.triangles, x);
  const PointDepth depth = point_depth(tree, x);
  const double size = (tree.box.high - tree.box.low).norm();
  CHECK(std::abs(std::abs(depth.depth) - distance) <= 1e-14 * size);
  CHECK(std::abs((x - depth.nearest).norm() - distance) <= 1e-14 * size);
  const auto triangle = static_cast<std::size_t>(depth.triangle);
  CHECK(nearest_points({depth.nearest, depth.nearest, depth.nearest}, tree.triangles[triangle]).distance <=
        1e-14 * size);
  if (distance > 1e-9 * size) {
    CHECK((depth.depth > 0) == (winding > 0.5));
    CHECK(contains(tree, x) == (winding > 0.5));
  }
  const double at_most = distance * between(random, 0.5, 1.5);
  const PointDepth bounded = point_depth(tree, x, at_most);
  if (at_most < std::abs(depth.depth)) {
    CHECK(bounded.triangle == no_index);
    CHECK(bounded.depth == at_most);
  } else {
    CHECK(bounded.triangle == depth.triangle);
    CHECK(bounded.depth == depth.depth);
  }
  const double least = depth.depth * between(random, 0.5, 1.5), above = depth_above(tree, x, least);
  if (depth.depth > least) {
    CHECK(above == depth.depth);
  } else {
    CHECK(above <= least);
  }
}

}  // namespace

TEST_CASE("the depth of points in and around the six bodies: exact distance, sign of the winding number") {
  Random random(21);
  for (const TriangleSurface& surface : {test::l_shape(), test::knot(), test::pawn(), test::hub(), test::mallet(),
                                         test::bumpy_sphere(), test::box(Vec3(-1, -2, -3), Vec3(1, 2, 3))}) {
    const SlabTree tree = build_slab_tree(surface);
    const Vec3 middle = 0.5 * (tree.box.low + tree.box.high), half = 0.5 * (tree.box.high - tree.box.low);
    for (int k = 0; k < 150; ++k) check_depth(tree, middle + 1.3 * half.cwiseProduct(random_vector(random, 1)), random);
    for (int k = 0; k < 150; ++k) {  // close to corners, edges and faces
      const Triangle& t = tree.triangles[random() % tree.triangles.size()];
      const double u = k % 3 == 0 ? 0 : between(random, 0, 1), v = k % 3 < 2 ? 0 : between(random, 0, 1 - u);
      const Vec3 on = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      check_depth(tree, on + std::pow(10, between(random, -7, -1)) * random_vector(random, 1), random);
    }
    for (const Vec3& p : surface.points) CHECK(std::abs(point_depth(tree, p).depth) < 1e-15);
  }
}

TEST_CASE("sharp wedges, needles and triangles without area have the right sign") {
  Random random(22);
  const TriangleSurface blade = test::prism({{0, 0}, {10, 0}, {10, 1e-5}}, 0, 1);    // an edge of 1e-6 rad
  const TriangleSurface star = test::sphere_grid(8, 5, [](double u, double polar) {  // needles from a small middle
    const double radius = std::abs(std::sin(2 * u)) < 0.5 && std::abs(polar - .5) < .01 ? 3 : .1;
    return Vec3(radius * std::sin(test::pi * polar) * std::cos(u), radius * std::sin(test::pi * polar) * std::sin(u),
                radius * std::cos(test::pi * polar));
  });
  TriangleSurface split = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));  // a corner on an edge, and the gap without area
  const auto extra = static_cast<LocalIndex>(split.points.size());
  const std::array<LocalIndex, 3> whole = split.triangles[0];
  split.points.push_back(
      0.5 * (split.points[static_cast<std::size_t>(whole[0])] + split.points[static_cast<std::size_t>(whole[1])]));
  split.triangles[0] = {whole[0], extra, whole[2]};
  split.triangles.push_back({extra, whole[1], whole[2]});
  split.triangles.push_back({whole[0], whole[1], extra});
  for (const TriangleSurface& surface : {blade, star, split}) {
    const SlabTree tree = build_slab_tree(surface);
    CHECK(self_crossings(tree).count == (surface.points.size() == 9 ? 2 : 0));  // the corner on the edge
    int wrong = 0;
    for (int k = 0; k < 2000; ++k) {
      const Triangle& t = tree.triangles[random() % tree.triangles.size()];
      const double u = k % 3 == 0 ? 0 : between(random, 0, 1), v = k % 3 < 2 ? 0 : between(random, 0, 1 - u);
      const Vec3 x = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]) +
                     std::pow(10, between(random, -8, 0)) * random_vector(random, 1);
      const PointDepth depth = point_depth(tree, x);
      if (std::abs(depth.depth) < 1e-12) continue;
      wrong += static_cast<int>((depth.depth > 0) != (winding_number(surface, x) > 0.5));
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("the winding number is 1 inside, 0 outside, and 1/2 on a face") {
  const TriangleSurface cube = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  CHECK(winding_number(cube, Vec3(.2, .3, -.4)) == Approx(1).epsilon(1e-14));
  CHECK(winding_number(cube, Vec3(1.2, .3, -.4)) == Approx(0).margin(1e-14));
  CHECK(point_depth(build_slab_tree(cube), Vec3(.2, .3, -.4)).depth == Approx(.6).epsilon(1e-15));
  CHECK(point_depth(build_slab_tree(cube), Vec3(2, 2, 2)).depth == Approx(-std::sqrt(3.0)).epsilon(1e-15));
}
