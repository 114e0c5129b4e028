// SPDX-License-Identifier: Apache-2.0
// Placing several bodies at once: exact answers of boxes, held directions, and what cannot be separated.
#include "depth/assembly.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <deque>
#include <numbers>
#include <random>
#include <vector>

#include "depth/encounter.hpp"
#include "support/depth_bodies.hpp"
#include "support/surface_samples.hpp"

using namespace brunt;
using namespace brunt::depth;

namespace {

TriangleSurface box(const Vec3& low, const Vec3& high) {
  return test::fans_of(test::box_surface(low, high));
}

TriangleSurface cube(const Vec3& low, double edge = 1) {
  return box(low, low + Vec3::Constant(edge));
}

TriangleSurface seen_from(TriangleSurface surface, const Placement& frame) {
  for (Vec3& x : surface.points) x = frame(x);
  return surface;
}

struct Scene {
  std::deque<Body> bodies;
  Assembly assembly;

  Member& add(const TriangleSurface& surface, double density = 1) {
    bodies.push_back(make_body(surface, {.balls = 20, .pieces = {}}));
    const Body* body = &bodies.back();
    assembly.members.push_back(make_member(std::span(&body, 1), std::span(&density, 1)));
    return assembly.members.back();
  }
  void add_fixed(const TriangleSurface& surface) {
    Member& member = add(surface);
    member.basis.setZero();
    member.turns = false;
  }
  AssemblyAnswer place() {
    assembly.pairs.clear();
    for (std::size_t a = 0; a < assembly.members.size(); ++a)
      for (std::size_t b = a + 1; b < assembly.members.size(); ++b)
        if (assembly.members[a].moves() || assembly.members[b].moves()) assembly.pairs.push_back({a, 0, b, 0});
    return place_apart(assembly);
  }
  [[nodiscard]] Placement placement(const AssemblyAnswer& answer, std::size_t k) const {
    return moved({}, answer.motions[k], assembly.members[k].centroid);
  }
  [[nodiscard]] bool any_overlap(const AssemblyAnswer& answer) const {
    for (const MemberPair& pair : assembly.pairs) {
      const Placement a = placement(answer, pair.a), b = placement(answer, pair.b);
      const Placement here{b.rotation.transpose() * a.rotation, b.back(a.translation)};
      if (Encounter{bodies[pair.a], bodies[pair.b], here}.bodies_collide(here)) return true;
    }
    return false;
  }
  /// |sum m T| / sum of the masses, over the largest displacement.
  [[nodiscard]] double drift(const AssemblyAnswer& answer) const {
    Vec3 sum = Vec3::Zero();
    double mass = 0, most = 0;
    for (std::size_t k = 0; k < assembly.members.size(); ++k) {
      sum += assembly.members[k].mass * answer.motions[k].shift;
      mass += assembly.members[k].mass;
      most = std::max(most, answer.farthest[k]);
    }
    return sum.norm() / mass / most;
  }
};

constexpr double d = 0.1;

}  // namespace

TEST_CASE("Two cubes part in the ratio of the other's mass", "[assembly]") {
  for (const double density : {1.0, 3.0}) {
    Scene scene;
    scene.add(cube({0, 0, 0}));
    scene.add(cube({1 - d, 0, 0}), density);
    const AssemblyAnswer answer = scene.place();
    REQUIRE(answer.found);
    CHECK(answer.farthest[0] == Approx(d * density / (1 + density)).margin(1e-5 * d));
    CHECK(answer.farthest[1] == Approx(d / (1 + density)).margin(1e-5 * d));
    CHECK((answer.motions[0].shift + Vec3(d * density / (1 + density), 0, 0)).norm() < 1e-5 * d);
    CHECK(answer.motions[0].turn.vec().norm() < 1e-5 * d);
    CHECK(answer.length == Approx(d * std::sqrt(density) / (1 + density)).epsilon(1e-5));
    CHECK_FALSE(scene.any_overlap(answer));
    CHECK(scene.drift(answer) < 1e-4);
  }
}

TEST_CASE("Cubes beside each other gain by a small turn", "[assembly]") {
  Scene scene;
  scene.add(cube({0, 0, 0}));
  scene.add(cube({1 - d, 0.05, -0.03}));
  const AssemblyAnswer answer = scene.place();
  REQUIRE(answer.found);
  CHECK(answer.length < 0.999 * d / 2);
  CHECK(answer.length > 0.99 * d / 2);
  CHECK_FALSE(scene.any_overlap(answer));
  CHECK(scene.drift(answer) < 1e-4);
}

TEST_CASE("A body that is fixed leaves the whole motion to the other", "[assembly]") {
  Scene scene;
  scene.add_fixed(cube({0, 0, 0}));
  scene.add(cube({0.02, 0.03, 1 - d}), 7);
  const AssemblyAnswer answer = scene.place();
  REQUIRE(answer.found);
  CHECK(answer.farthest[0] == 0);
  CHECK((answer.motions[1].shift - Vec3(0, 0, d)).norm() < 1e-5 * d);
  CHECK_FALSE(scene.any_overlap(answer));
}

TEST_CASE("A row of three cubes moves at its ends", "[assembly]") {
  Scene scene;
  for (int k = 0; k < 3; ++k) scene.add(cube({k * (1 - d), 0, 0}));
  const AssemblyAnswer answer = scene.place();
  REQUIRE(answer.found);
  CHECK((answer.motions[0].shift + Vec3(d, 0, 0)).norm() < 1e-5 * d);
  CHECK(answer.motions[1].shift.norm() < 1e-5 * d);
  CHECK((answer.motions[2].shift - Vec3(d, 0, 0)).norm() < 1e-5 * d);
  CHECK_FALSE(scene.any_overlap(answer));
}

TEST_CASE("Members of several surfaces move as one", "[assembly]") {
  Scene scene;
  scene.add(cube({0, 0, 0}));
  scene.add(cube({1 - d, 0, 0}));
  scene.bodies.push_back(make_body(cube({2 - d, 0, 0}), {.balls = 20, .pieces = {}}));
  const std::array<const Body*, 2> both{&scene.bodies[1], &scene.bodies[2]};
  scene.assembly.members[1] = make_member(both, std::array{1.0, 1.0});
  scene.assembly.pairs = {{0, 0, 1, 0}, {0, 0, 1, 1}};
  CHECK(scene.assembly.members[1].mass == Approx(2));
  CHECK((scene.assembly.members[1].centroid - Vec3(2 - d, 0.5, 0.5)).norm() < 1e-12);
  const AssemblyAnswer answer = place_apart(scene.assembly);
  REQUIRE(answer.found);
  CHECK((answer.motions[0].shift + Vec3(2 * d / 3, 0, 0)).norm() < 1e-5 * d);
  CHECK((answer.motions[1].shift - Vec3(d / 3, 0, 0)).norm() < 1e-5 * d);
}

TEST_CASE("Cubes between fixed walls find the room that there is", "[assembly]") {
  Scene scene;
  scene.add_fixed(box({-1, -1, -1}, {0, 3.3, 3.3}));
  scene.add_fixed(box({2.3, -1, -1}, {3.3, 3.3, 3.3}));
  scene.add_fixed(box({0, -1, -1}, {2.3, 0, 3.3}));
  scene.add_fixed(box({0, 1.2, -1}, {2.3, 2.2, 3.3}));
  scene.add_fixed(box({0, 0, -1}, {2.3, 1.2, 0}));
  scene.add(cube({-0.05, 0.05, -0.02}));
  scene.add(cube({0.9, 0.1, 0.04}));
  scene.add(cube({0.05, -0.04, 0.93}));
  scene.add(cube({0.95, 0.15, 0.9}));
  const AssemblyAnswer answer = scene.place();
  REQUIRE(answer.found);
  CHECK_FALSE(scene.any_overlap(answer));
  for (std::size_t k = 5; k < 9; ++k) {
    const Vec3 centre = scene.assembly.members[k].centroid + answer.motions[k].shift;
    CHECK(centre[0] > 0.5 - 1e-6);
    CHECK(centre[0] < 1.8 + 1e-6);
    CHECK(answer.farthest[k] < 0.3);
  }
}

TEST_CASE("Bodies that may only move in a plane stay in it", "[assembly]") {
  Scene scene;
  for (const double z : {0.0, 0.95}) {  // the shortest way is along z
    Member& member = scene.add(cube({0.8 * z, 0.3 * z, z}));
    member.basis.col(2).setZero();
    member.turns = false;
  }
  const AssemblyAnswer answer = scene.place();
  REQUIRE(answer.found);
  const double overlap = 1 - 0.8 * 0.95;
  for (const double sign : {0, 1}) {
    const Vec3& shift = answer.motions[static_cast<std::size_t>(sign)].shift;
    CHECK((shift - Vec3((sign > 0 ? 0.5 : -0.5) * overlap, 0, 0)).norm() < 1e-5 * overlap);
    CHECK(shift[2] == 0);
  }
  CHECK_FALSE(scene.any_overlap(answer));
}

TEST_CASE("What cannot be separated is reported", "[assembly]") {
  SECTION("both stay") {
    Scene scene;
    scene.add_fixed(cube({0, 0, 0}));
    scene.add_fixed(cube({0.5, 0, 0}));
    scene.assembly.pairs = {{0, 0, 1, 0}};
    const AssemblyAnswer answer = place_apart(scene.assembly);
    CHECK_FALSE(answer.found);
    CHECK(answer.left == std::vector<std::size_t>{0});
  }
  SECTION("a body in a larger one that may only turn") {
    Scene scene;
    Member& inner = scene.add(cube({0, 0, 0}));
    inner.basis.setZero();
    scene.add_fixed(cube({-1, -1, -1}, 3));
    const AssemblyAnswer answer = scene.place();
    CHECK_FALSE(answer.found);
    CHECK(answer.motions.empty());
    CHECK(answer.left == std::vector<std::size_t>{0});
  }
}

TEST_CASE("Round and long bodies that may turn: free, balanced, never longer than by translations", "[assembly]") {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  Scene scene, slides;
  for (int k = 0; k < 6; ++k) {
    const Vec3 size(1.5 + 0.5 * unit(engine), 0.5 + 0.2 * unit(engine), 0.4 + 0.1 * unit(engine));
    Placement at;
    at.rotation =
        Eigen::AngleAxisd(3 * unit(engine), Vec3(unit(engine), unit(engine), unit(engine)).normalized()).matrix();
    at.translation = Vec3(0.7 * unit(engine), 0.7 * unit(engine), 0.7 * unit(engine));
    const TriangleSurface surface = seen_from(box(-0.5 * size, 0.5 * size), at);
    const double density = 2 + unit(engine);
    scene.add(surface, density);
    slides.add(surface, density).turns = false;
  }
  const AssemblyAnswer answer = scene.place(), straight = slides.place();
  REQUIRE(answer.found);
  REQUIRE(straight.found);
  CHECK_FALSE(scene.any_overlap(answer));
  CHECK_FALSE(slides.any_overlap(straight));
  CHECK(scene.drift(answer) < 1e-4);
  CHECK(slides.drift(straight) < 1e-4);
  CHECK(answer.length < straight.length * (1 + 1e-6));
  INFO("turning " << answer.length << ", translations " << straight.length << ", steps " << answer.steps);
  CHECK(answer.length < 0.99 * straight.length);
}

TEST_CASE("Another frame gives the same motions, turned", "[assembly]") {
  Placement frame;
  frame.rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).matrix();
  frame.translation = Vec3(3, -2, 5);
  Scene here, there;
  const std::array<TriangleSurface, 3> surfaces{cube({0, 0, 0}), box({0.9, 0.1, 0}, {2.1, 0.8, 0.7}),
                                                box({0.2, 0.95, 0.1}, {1.4, 1.6, 0.8})};
  for (const TriangleSurface& surface : surfaces) {
    here.add(surface);
    there.add(seen_from(surface, frame));
  }
  const AssemblyAnswer one = here.place(), other = there.place();
  REQUIRE(one.found);
  REQUIRE(other.found);
  CHECK(one.length == Approx(other.length).epsilon(1e-6));
  for (std::size_t k = 0; k < 3; ++k)
    CHECK((frame.rotation * one.motions[k].shift - other.motions[k].shift).norm() < 1e-4 * one.length);
  const AssemblyAnswer again = here.place();
  for (std::size_t k = 0; k < 3; ++k) CHECK(again.motions[k].shift == one.motions[k].shift);  // the same bits
}
