// SPDX-License-Identifier: Apache-2.0
// The certificate: proofs are checked against placements at random, bounds against closed forms.
#include "depth/cover.hpp"

#include <catch2/catch.hpp>

#include "depth/penetration_depth.hpp"
#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;

namespace {

std::vector<Vec3> corners(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]);
  return points;
}

Body brick(const Vec3& half) {
  return make_body(test::box(-half, half), {400, {corners(-half, half)}});
}

}  // namespace

TEST_CASE("every placement in a box that is dropped collides") {
  const Body a = make_body(test::l_shape(), {400, {corners({0, 0, 0}, {2, .6, .5})}}), b = make_body(test::hub());
  test::Random random(1);
  int dropped = 0;
  for (int i = 0; i < 3000; ++i) {
    Encounter encounter{a, b, random.placement(0.8)};
    CoverBox box;
    box.turn = 0.5 * random.vector();
    box.shift = 0.5 * random.vector();
    box.half_turn = random.uniform(0, 0.1);
    for (int c = 0; c < 3; ++c) box.half_shift[c] = random.uniform(0, 0.1);
    if (!judge(encounter, Metric::displacement, 1, box).collides) continue;
    ++dropped;
    for (int k = 0; k < 20; ++k) {
      const auto inside = [&](const Vec3& middle, const Vec3& half) {
        const Vec3 share(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        return Vec3(middle + half.cwiseProduct(share));
      };
      const Vec3 turn = inside(box.turn, Vec3::Constant(box.half_turn)), shift = inside(box.shift, box.half_shift);
      CHECK(encounter.collides({rotation_of(turn), shift}));
    }
  }
  CHECK(dropped > 100);
}

TEST_CASE("boxes face to face are certified; batches may be judged in any order") {
  const Body cube = brick({1, 1, 1});
  for (const Metric metric : {Metric::translation, Metric::displacement, Metric::object_norm}) {
    Query query;
    query.a_in_b = {Mat3::Identity(), {1.5, .13, .07}};
    query.metric = metric;
    query.gap = 0.05;
    query.boxes = 20000;
    const Answer here = penetration_depth(cube, cube, query);
    CHECK(here.depth == Approx(.5).epsilon(1e-5));
    CHECK(here.bound <= here.depth);
    if (metric != Metric::object_norm) CHECK(here.bound > .475);
    query.evaluate = [&](std::span<const CoverBox> boxes, double upper, std::span<CoverVerdict> verdicts) {
      const Encounter encounter{cube, cube, rounded(query.a_in_b, cube.shape.radius)};
      for (std::size_t i = boxes.size(); i-- > 0;) verdicts[i] = judge(encounter, metric, upper, boxes[i]);
    };
    const Answer elsewhere = penetration_depth(cube, cube, query);
    CHECK(elsewhere.bound == here.bound);
    CHECK(elsewhere.depth == here.depth);
    CHECK(elsewhere.boxes == here.boxes);
  }
}
