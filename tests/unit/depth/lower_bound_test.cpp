// SPDX-License-Identifier: Apache-2.0
// The lower bound at one placement is the greatest over all points.
#include "depth/lower_bound.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;

namespace {

Body without_pieces(const TriangleSurface& surface) {
  Body body = make_body(surface);
  body.pieces.clear();
  body.piece_reach.clear();
  return body;
}

/// The greatest bound of random points of A's bounding box that lie in A.
double sampled(const Encounter& encounter, Metric metric, int points, test::Random& random) {
  const geometry::Box& box = encounter.a.tree.box;
  double most = 0;
  for (int i = 0; i < points; ++i) {
    Vec3 x;
    for (int c = 0; c < 3; ++c) x[c] = random.uniform(box.low[c], box.high[c]);
    const double in_a = geometry::point_depth(encounter.a.tree, x).depth;
    if (in_a < 0) continue;
    const double sum = in_a + geometry::point_depth(encounter.b.tree, encounter.start(x)).depth;
    const double factor =
        metric == Metric::object_norm ? point_factor(encounter.a.shape.gyration, x - encounter.a.shape.centroid) : 1.0;
    most = std::max(most, sum / std::sqrt(factor));
  }
  return most;
}

}  // namespace

TEST_CASE("cubes face on: the bound is the overlap, though no ball's centre tells it") {
  const Body cube = without_pieces(test::box({-1, -1, -1}, {1, 1, 1}));
  for (const double distance : {1.9, 1.5, 1.0, .5}) {
    const Encounter encounter{cube, cube, {Mat3::Identity(), {distance, .13, .07}}};
    CHECK(lower_bound(encounter, Metric::displacement).value == Approx(2 - distance).epsilon(1e-9));
  }
}

TEST_CASE("no point of A bounds more") {
  const Body l = without_pieces(test::l_shape()), pawn = without_pieces(test::pawn());
  test::Random random(11);
  for (int i = 0; i < 20; ++i) {
    const Encounter encounter{
        l, pawn, {random.rotation().toRotationMatrix(), random.uniform(0, 1) * random.direction()}};
    for (const Metric metric : {Metric::displacement, Metric::object_norm})
      CHECK(lower_bound(encounter, metric).value >= sampled(encounter, metric, 3000, random));
  }
}

TEST_CASE("of a box the points farthest from each other are its corners, then there are no more") {
  const TriangleSurface box = test::box({0, 0, 0}, {1, 2, 3});
  const std::vector<Vec3> chosen = spread_points(box.points, {.4, .9, 1.4}, 20);
  REQUIRE(chosen.size() == 8);
  CHECK(chosen[0] == Vec3(1, 2, 3));
  CHECK(chosen[1] == Vec3(0, 0, 0));
  CHECK(spread_points(box.points, {.4, .9, 1.4}, 3).size() == 3);
}
