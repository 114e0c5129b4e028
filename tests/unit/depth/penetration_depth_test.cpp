// SPDX-License-Identifier: Apache-2.0
// The one call: closed forms, disjoint and contained bodies, frames, order, certificates of contact.
#include "depth/penetration_depth.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;

namespace {

constexpr Metric metrics[] = {Metric::translation, Metric::displacement, Metric::object_norm};

Query query_of(const Placement& pose, Metric metric, bool careful = false) {
  Query query;
  query.a_in_b = pose;
  query.metric = metric;
  query.careful = careful;
  return query;
}

/// Free, touching, consistent with its own motion, and above its bound.
void check_answer(const Body& a, const Body& b, const Query& query, const Answer& answer) {
  Encounter encounter{a, b, rounded(query.a_in_b, a.shape.radius)};
  CHECK(answer.found);
  CHECK_FALSE(encounter.bodies_collide(answer.placement));
  CHECK(answer.bound <= answer.depth);
  CHECK(answer.depth == Approx(length_of(a.shape, query.metric, answer.motion)).epsilon(1e-14));
  CHECK(encounter.collides(along_screw(answer.motion, 1 - (query.careful ? 1e-6 : 1e-5))));
  CHECK_FALSE(answer.contacts.empty());
}

}  // namespace

TEST_CASE("bodies apart have depth 0 and their distance; a body inside another has a depth") {
  const Body unit = make_body(test::box({-.5, -.5, -.5}, {.5, .5, .5})),
             large = make_body(test::box({-2, -2, -2}, {2, 2, 2}));
  for (const Metric metric : metrics) {
    const Answer apart = penetration_depth(unit, large, query_of({Mat3::Identity(), {4, 0, 0}}, metric));
    CHECK_FALSE(apart.overlap);
    CHECK(apart.depth == 0);
    CHECK(apart.distance == Approx(1.5).epsilon(1e-12));
    const Query inside = query_of({}, metric, true);
    const Answer contained = penetration_depth(unit, large, inside);
    CHECK(contained.overlap);
    CHECK(contained.depth == Approx(2.5).epsilon(1e-6));
    check_answer(unit, large, inside, contained);
  }
}

TEST_CASE("cubes, a corner and a beam have the depths of their closed forms") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1}));
  for (const double d : {1.9, 1.0}) {
    const Query query = query_of({Mat3::Identity(), {d, .13, .07}}, Metric::displacement, true);
    CHECK(penetration_depth(cube, cube, query).depth == Approx(2 - d).epsilon(1e-6));
  }
  const Body beam = make_body(test::box({-5, -.5, -.25}, {5, .5, .25})),
             block = make_body(test::box({4.5, -3, -4}, {7, 3, 0}));
  const Query query = query_of({Mat3::Identity(), {0, 0, .05}}, Metric::object_norm, true);
  const Answer answer = penetration_depth(beam, block, query);
  CHECK(answer.depth == Approx(.108108221).epsilon(1e-6));
  check_answer(beam, block, query, answer);
}

TEST_CASE("random poses of the three pairs: free, touching, above the bound, in order, the same bits again") {
  const TriangleSurface as[] = {test::l_shape(), test::pawn(), test::mallet()};
  const TriangleSurface bs[] = {test::knot(), test::hub(), test::bumpy_sphere()};
  for (int pair = 0; pair < 3; ++pair) {
    const Body a = make_body(as[pair]), b = make_body(bs[pair]);
    std::mt19937_64 random(17);
    for (int i = 0; i < 6; ++i) {
      const Placement pose = test::random_placement(as[pair], bs[pair], random);
      if (!Encounter{a, b, pose}.bodies_collide(pose)) continue;
      std::vector<Placement> others;
      std::array<double, 3> depth{};
      for (std::size_t m = 0; m < 3; ++m) {
        Query query = query_of(pose, metrics[m]);
        query.tries = others;
        const Answer answer = penetration_depth(a, b, query), again = penetration_depth(a, b, query);
        check_answer(a, b, query, answer);
        CHECK(again.depth == answer.depth);
        CHECK(again.bound == answer.bound);
        CHECK(again.placement.rotation == answer.placement.rotation);
        depth[m] = answer.depth;
        others.push_back(answer.placement);
      }
      CHECK(depth[1] <= depth[0] * (1 + 1e-6));
      CHECK(depth[2] <= depth[1] * (1 + 1e-6));
    }
  }
}

TEST_CASE("a translation along one direction; none where that direction is held") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1}));
  Query query = query_of({Mat3::Identity(), {1.5, .3, 0}}, Metric::translation, true);
  query.along = {Vec3::UnitY()};
  const Answer answer = penetration_depth(cube, cube, query);
  CHECK(answer.depth == Approx(1.7).epsilon(1e-6));
  CHECK(answer.placement.translation[0] == Approx(1.5).epsilon(1e-11));
  query.metric = Metric::displacement;
  CHECK_THROWS_AS(penetration_depth(cube, cube, query), std::invalid_argument);
}

TEST_CASE("a moved world frame, permuted triangles and a scaled pair give the same depth") {
  TriangleSurface surface_a = test::l_shape(), surface_b = test::hub();
  const Body a = make_body(surface_a), b = make_body(surface_b);
  test::Random random(5);
  const Placement pose{random.rotation().toRotationMatrix(), {.6, .3, .2}};
  REQUIRE(Encounter{a, b, pose}.bodies_collide(pose));
  for (const Metric metric : metrics) {
    const Answer answer = penetration_depth(a, b, query_of(pose, metric));
    const Placement world = random.placement();
    const Placement a_in_world{world.rotation * pose.rotation, world(pose.translation)};
    Placement relative{world.rotation.transpose() * a_in_world.rotation, world.back(a_in_world.translation)};
    CHECK(penetration_depth(a, b, query_of(relative, metric)).depth == Approx(answer.depth).epsilon(1e-8));
    TriangleSurface mixed = surface_a;
    std::reverse(mixed.triangles.begin(), mixed.triangles.end());
    for (auto& t : mixed.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
    CHECK(penetration_depth(make_body(mixed), b, query_of(pose, metric)).depth == answer.depth);
    TriangleSurface big_a = surface_a, big_b = surface_b;
    for (Vec3& x : big_a.points) x *= 4;
    for (Vec3& x : big_b.points) x *= 4;
    const Answer scaled =
        penetration_depth(make_body(big_a), make_body(big_b), query_of({pose.rotation, 4 * pose.translation}, metric));
    CHECK(scaled.depth == Approx(4 * answer.depth).epsilon(1e-6));
  }
}

TEST_CASE("a distance that is asked for is left between the surfaces, in all metrics and modes") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1})), hub = make_body(test::hub()),
             pawn = make_body(test::pawn());
  constexpr double apart = .05;
  for (const bool careful : {false, true})
    for (const Metric metric : metrics) {
      Query query = query_of({Mat3::Identity(), {1.9, .13, .07}}, metric, careful);
      query.apart = apart;
      const Answer boxes = penetration_depth(cube, cube, query);
      if (metric != Metric::object_norm) CHECK(boxes.depth == Approx(.1 + apart).epsilon(1e-5));
      CHECK(boxes.depth < .1 + apart + 1e-6);
      CHECK(boxes.bound <= boxes.depth);
      if (metric != Metric::object_norm) CHECK(boxes.bound == Approx(.1 + apart).epsilon(1e-9));
      CHECK(geometry::surface_distance(cube.tree, cube.tree, boxes.placement) == Approx(apart).epsilon(1e-4));
      query.a_in_b.translation = {.85, .6, .7};
      const Answer round = penetration_depth(pawn, hub, query);
      REQUIRE(round.found);
      CHECK(geometry::surface_distance(pawn.tree, hub.tree, round.placement) == Approx(apart).epsilon(1e-4));
      CHECK_FALSE(round.contacts.empty());
      CHECK(round.bound <= round.depth);
    }
}

TEST_CASE("a certificate counts the distance that is left") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1})), l = make_body(test::l_shape());
  Query query = query_of({Mat3::Identity(), {2.2, .1, .1}}, Metric::translation, true);
  query.apart = .1;
  query.boxes = 20000;
  query.gap = .05;
  const Answer answer = penetration_depth(cube, l, query);
  CHECK(answer.certified);
  CHECK(answer.bound > answer.depth * .95);
  CHECK(answer.bound <= answer.depth);
}

TEST_CASE("a body that is a millionth of the other finds its way out in few queries") {
  const Body tiny = make_body(test::box(Vec3::Constant(-5e-4), Vec3::Constant(5e-4))),
             huge = make_body(test::box(Vec3::Constant(-500), Vec3::Constant(500)));
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(100, 30, -20)})
    for (const Metric metric : metrics) {
      const Answer answer = penetration_depth(tiny, huge, query_of({Mat3::Identity(), at}, metric));
      CHECK(answer.depth == Approx(500.0005 - at[0]).epsilon(1e-4));  // the fast mode's accuracy
      CHECK(answer.queries < 100000);
    }
}

TEST_CASE("normals of contacts are unit, and those of the faces where the gap is rounding") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1}));
  for (const bool careful : {false, true})
    for (const double d : {1.5, 1.9, 1.0, 1.7 / 3}) {
      const Answer answer =
          penetration_depth(cube, cube, query_of({Mat3::Identity(), {d, .13, .07}}, Metric::translation, careful));
      REQUIRE_FALSE(answer.contacts.empty());
      for (const ContactPoint& contact : answer.contacts) {
        CHECK(contact.normal.norm() == Approx(1).epsilon(1e-14));
        CHECK((contact.normal - Vec3::UnitX()).norm() < 1e-6);
      }
    }
}

TEST_CASE("bodies that touch do not overlap; they are parted where that is asked for") {
  const Body cube = make_body(test::box({-1, -1, -1}, {1, 1, 1})), small = make_body(test::box({0, 0, 0}, {1, 1, 1})),
             l = make_body(test::prism({{0, 0}, {2, 0}, {2, .5}, {.5, .5}, {.5, 2}, {0, 2}}, 0, .5));
  const struct {
    const Body &a, &b;
    Vec3 at;
  } cases[] = {{cube, cube, {2, 0, 0}},       // faces
               {cube, cube, {2, 2, .5}},      // edges
               {cube, cube, {2, 2, 2}},       // corners
               {small, cube, {1, .25, -.5}},  // a face on a part of another
               {small, l, {.5, .5, -.25}}};   // in a corner
  for (const auto& c : cases)
    for (const Metric metric : metrics)
      for (const bool careful : {false, true}) {
        Query query = query_of({Mat3::Identity(), c.at}, metric, careful);
        const Answer answer = penetration_depth(c.a, c.b, query);
        CHECK_FALSE(answer.overlap);
        CHECK(answer.depth == 0);
        CHECK(answer.bound == 0);
        CHECK(answer.distance == 0);
        query.touching = true;
        const Answer parted = penetration_depth(c.a, c.b, query);
        CHECK(parted.overlap);
        CHECK(parted.depth < 1e-5);
        CHECK_FALSE(Encounter{c.a, c.b, {}}.bodies_collide(parted.placement));
      }
  // a body inside another that touches it from inside does overlap
  CHECK(penetration_depth(small, cube, query_of({}, Metric::translation)).depth == Approx(1).epsilon(1e-5));
}
