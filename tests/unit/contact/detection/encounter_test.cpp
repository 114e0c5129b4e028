// SPDX-License-Identifier: Apache-2.0
// Rims of faces and paths through them: nothing slips past an edge, nothing is met that the node never reaches.
#include "contact/detection/encounter.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

#include "contact/detection/features.hpp"
#include "few_faces.hpp"

using namespace brunt;
using contact::Encounter;
using contact::Meeting;
using support::FewFaces;

namespace {

Encounter meet(FewFaces& scene, const Vec3& position, const Vec3& velocity, LocalIndex face) {
  std::vector<contact::FaceReach> reach(scene.faces.size(), {.box = {}, .size = 1});
  const contact::NodeMotion slave{position, velocity, velocity};
  return encounter({scene.faces, reach, scene.motion, scene.dt, *scene.settings.tolerances}, slave, face);
}

void settle(const FewFaces& scene, std::span<Encounter> met) {
  resolve_features({scene.faces, {}, scene.motion, scene.dt, *scene.settings.tolerances}, scene.settings.criterion,
                   met);
}

constexpr LocalIndex top = 5;

}  // namespace

TEST_CASE("closest point: inside, above or nothing, with region, height and distance beside") {
  FewFaces scene = support::cube();
  Encounter e = meet(scene, {0.3, 0.6, 1.1}, Vec3::Zero(), top);
  CHECK(e.meeting == Meeting::above);
  CHECK(e.region == geometry::Region::face);
  CHECK(e.height == Approx(0.1));
  CHECK(e.slow);
  e = meet(scene, {0.3, 0.6, 0.95}, Vec3::Zero(), top);
  CHECK(e.meeting == Meeting::inside);
  CHECK(e.gap == Approx(-0.05));
  e = meet(scene, {1.01, 0.6, 1.1}, Vec3::Zero(), top);
  CHECK(e.meeting == Meeting::above);  // within the rim
  CHECK(e.beside == Approx(0.01));
  e = meet(scene, {1.03, 0.6, 1.1}, Vec3::Zero(), top);
  CHECK(e.meeting == Meeting::none);
  CHECK(e.height == Approx(0.1));
  CHECK_FALSE(meet(scene, {0.3, 0.6, 1.1}, {0, 0, -51}, top).slow);  // 0.051 of the edge in a step
}

TEST_CASE("behind a rim and beside it: only what no neighbour has in front, or what is behind all of them") {
  FewFaces scene = support::cube();
  scene.facets = {Vec3(-1, 0, -1).normalized()};
  CHECK(scene.rows({1.01, 0.5, 0.99}, Vec3::Zero()).size() == 1);  // above the side x = 1
  CHECK((scene.rows({1.01, 0.5, 0.99})[0].normal - Vec3::UnitX()).norm() < 1e-14);
  FewFaces valley = support::two_slopes(120);
  CHECK(valley.rows({0, 0.5, -0.1}).size() == 2);  // far behind both, and beside both: it fell into the groove
}

TEST_CASE("at an edge sharper than a right angle a node may be behind one face, over it, and outside all the same") {
  FewFaces ridge = support::two_slopes(280);  // 80 degrees inside
  for (const double out : {1e-9, 1e-3}) {
    // on one slope and a little in front of it, deep behind the other, over which it lies as well
    const double half = 40 * std::numbers::pi / 180;
    const Vec3 down(std::sin(half), 0, -std::cos(half)), normal(std::cos(half), 0, std::sin(half));
    const auto rows = ridge.rows(Vec3(0, 0.5, 0) + 0.05 * down + out * normal);
    CAPTURE(out);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].normal.dot(normal) > 0.9);
    CHECK(rows[0].gap == Approx(out));
  }
}

// Of the faces beyond the ridge, that of the next span shares one node with the one that the node lies on. The face of
// the next span on this side does not tell either, where a load has bent the ridge: the node is behind its plane.
TEST_CASE("a node on one slope of a ridge is on it however near it is to where the next faces begin") {
  for (const double degrees : {280.0, 270.0}) {  // 80 degrees inside, or square to rounding
    const double half = 0.5 * (360 - degrees) * std::numbers::pi / 180;
    const Vec3 down(std::sin(half), 0, -std::cos(half)), normal(std::cos(half), 0, std::sin(half));
    const Vec3 other(-down.x(), 0, down.z()), step = Vec3::UnitY(), bent(0, 2, -1e-3);
    FewFaces ridge({Vec3::Zero(), step, bent, down, down + step, down + bent, other, other + step, other + bent},
                   {{0, 3, 4, 1}, {1, 4, 5, 2}, {0, 1, 7, 6}, {1, 2, 8, 7}});
    for (const double along : {0.5, 0.985, 0.9999})
      for (const double out : {1e-12, 1e-9}) {
        CAPTURE(degrees, along, out);
        const auto rows = ridge.rows(along * step + 0.01 * down + out * normal);
        REQUIRE(rows.size() == 1);
        CHECK(rows[0].normal.dot(normal) > 0.9);
        CHECK(rows[0].gap == Approx(out));
      }
  }
}

TEST_CASE("what a neighbour in front forbids does not depend on the order of the faces") {
  const auto kept = [](FewFaces scene, const Vec3& position, const std::vector<LocalIndex>& order) {
    std::vector<Encounter> met;
    for (const LocalIndex face : order) {
      met.push_back(meet(scene, position, Vec3::Zero(), face));
      met.back().opposition = -scene.facets[0].dot(met.back().normal);
    }
    settle(scene, met);
    return met.front().meeting;
  };
  // over the top's corner, and in front of two sides: y = 1, which the slave's surface does not oppose, and x = 1
  FewFaces cube = support::cube();
  cube.facets = {Vec3(-1, 0, -1).normalized()};
  constexpr LocalIndex right = 1, rear = 2;
  CHECK(kept(cube, {1.005, 1.005, 1.1}, {top, rear, right}) == Meeting::none);
  CHECK(kept(cube, {1.005, 1.005, 1.1}, {top, right, rear}) == Meeting::none);
  // a flat surface, bent by rounding: a node over one face still meets those whose rim is within reach
  FewFaces flat = support::flat();
  flat.motion[5].position.z() = 1e-15;
  for (const std::vector<LocalIndex>& order : {std::vector<LocalIndex>{0, 1, 2, 3}, {0, 3, 2, 1}, {0, 2, 1, 3}})
    CHECK(kept(flat, {0.005, 0.005, 0.1}, order) == Meeting::above);
}

TEST_CASE("behind a flat surface one face has the penetration, those beside the node defer to it") {
  FewFaces flat = support::flat();
  std::vector<Encounter> met;
  for (LocalIndex face = 0; face < 4; ++face) {
    met.push_back(meet(flat, {0.005, 0.005, -0.01}, Vec3::Zero(), face));
    met.back().opposition = 1;
  }
  settle(flat, met);
  for (LocalIndex face = 0; face < 3; ++face) CHECK(met[static_cast<std::size_t>(face)].meeting == Meeting::deferred);
  CHECK(met[3].meeting == Meeting::inside);
}

// A corner that is pressed into a mesh makes a pit of four skewed faces about a node. It fell through the one that was
// dropped since another one had it in front by a millionth.
TEST_CASE("at the bottom of a pit all slopes hold, whichever of them has the node in front by a little") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> noise(-0.15, 0.15), little(-1e-6, 1e-6);
  const auto some = [&](auto& spread) { return Vec3(spread(engine), spread(engine), spread(engine)); };
  int pits = 0;
  for (int k = 0; k < 1000; ++k) {
    FewFaces pit = support::flat();
    for (std::size_t n = 0; n < 9; ++n) {
      Vec3& x = pit.motion[n].position;
      if (n != 4) x += Vec3(0, 0, 0.5 * (std::abs(x.x()) + std::abs(x.y()))) + some(noise);
    }
    const Vec3 node = some(little);
    std::vector<Encounter> met;
    for (LocalIndex face = 0; face < 4; ++face) {
      met.push_back(meet(pit, node, Vec3::Zero(), face));
      met.back().opposition = met.back().normal.z();
    }
    const auto concave_to_all = [&](const Encounter& a) {
      return std::ranges::all_of(met, [&](const Encounter& b) {
        return a.face == b.face || concave({pit.faces, {}, pit.motion, pit.dt, *pit.settings.tolerances}, a, b);
      });
    };
    if (!std::ranges::all_of(met, concave_to_all)) continue;
    ++pits;
    settle(pit, met);
    for (const Encounter& e : met) CHECK((e.meeting == Meeting::inside || e.meeting == Meeting::above));
  }
  CHECK(pits > 500);
}

TEST_CASE("a path is judged wherever a step starts and ends: 10000 shots at the inside of a face, from both sides") {
  FewFaces scene = support::cube();
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> inner(0.0, 1.0), height(1e-6, 5.0), slant(-1, 1);
  for (int shot = 0; shot < 10000; ++shot) {
    const Vec3 target(inner(engine), inner(engine), 1);
    const double grazing = shot % 3 == 0 ? std::tan(std::numbers::pi / 180) : 1.0;  // 1 degree to the face
    const Vec3 aside(slant(engine), slant(engine), 0);
    Vec3 direction = aside.norm() > 0 ? Vec3(aside.normalized()) : Vec3(Vec3::UnitX());
    direction.z() = -grazing;
    const double before = height(engine) / grazing * (grazing < 1 ? 1e-2 : 1), after = 1e-6 + height(engine);
    const Vec3 start = target - before * direction;
    const Vec3 velocity = (before + after) / scene.dt * direction;
    scene.facets = {-Vec3::UnitZ()};
    auto rows = scene.rows(start, velocity);
    CAPTURE(shot, start.transpose(), velocity.transpose());
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].key.master == top);
    // the impact: gap over approach is its share of the step
    const double share = rows[0].gap / (-rows[0].normal.dot(velocity) * scene.dt);
    CHECK(std::abs(share - before / (before + after)) <= 1e-9);
    for (contact::NodeMotion& corner : scene.motion) corner.predicted = -velocity;  // the face flies at the node
    rows = scene.rows(start, Vec3::Zero());
    CHECK(rows.size() == 1);
    for (contact::NodeMotion& corner : scene.motion) corner.predicted = Vec3::Zero();
  }
}

TEST_CASE("a node on its way out meets nothing, and one that passes beside meets nothing") {
  FewFaces scene = support::cube();
  CHECK(scene.rows({0.5, 0.5, 1.3}, {0, 0, 900}).empty());
  CHECK(scene.rows({1.1, 0.5, 1.3}, {0, 0, -200}).empty());
  CHECK(scene.rows({1.5, 0.5, 1.01}, {-900, 0, 0}).empty());  // over the top, parallel to it, and above: out of reach
}

TEST_CASE("many pairs at a time: each as alone, triangles and faces without area among them") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-0.4, 1.4), speed(-60, 60);
  FewFaces scene = support::cube();
  scene.faces.push_back({.key = 6, .nodes = {4, 5, 6, 0}, .corner_count = 3});
  scene.faces.push_back({.key = 7, .nodes = {0, 1, 1, 0}});
  for (contact::NodeMotion& node : scene.motion) {
    node.position += 0.1 * Vec3(place(random), place(random), place(random));
    node.predicted = Vec3(speed(random), speed(random), speed(random));
  }
  const std::vector<contact::FaceReach> reach(scene.faces.size(), {.box = {}, .size = 1.1});
  const contact::FacesInMotion faces{scene.faces, reach, scene.motion, scene.dt, *scene.settings.tolerances};
  std::vector<contact::NodeMotion> slaves;
  for (int k = 0; k < 300; ++k)
    slaves.push_back({Vec3(place(random), place(random), place(random)), Vec3::Zero(), Vec3(0, 0, speed(random))});
  std::vector<const contact::NodeMotion*> slave_of;
  std::vector<Encounter> met;
  for (const contact::NodeMotion& slave : slaves)
    for (LocalIndex f = 0; f < static_cast<LocalIndex>(scene.faces.size()); ++f) {
      slave_of.push_back(&slave);
      met.push_back({.face = f, .approach = {.side = f % 3 == 0 ? -1.0 : 1.0, .clearance = 0.01 * f}});
    }
  encounter_all(faces, slave_of, met);
  std::array<int, 5> seen{};
  for (std::size_t k = 0; k < met.size(); ++k) {
    const Encounter& e = met[k];
    const Encounter alone = encounter(faces, *slave_of[k], e.face, e.approach);
    ++seen[static_cast<std::size_t>(e.meeting)];
    REQUIRE(e.meeting == alone.meeting);
    REQUIRE(e.region == alone.region);
    REQUIRE(e.slow == alone.slow);
    REQUIRE(e.size == alone.size);
    REQUIRE(std::isnan(e.height) == std::isnan(alone.height));
    if (std::isnan(e.height)) continue;
    REQUIRE(std::abs(e.height - alone.height) < 1e-13);
    REQUIRE(e.gap == e.height);
    REQUIRE(std::abs(e.beside - alone.beside) < 1e-13);
    REQUIRE((e.normal - alone.normal).norm() < 1e-13);
    REQUIRE((e.point - alone.point).norm() < 1e-13);
    for (std::size_t i = 0; i < 4; ++i) REQUIRE(std::abs(e.weights[i] - alone.weights[i]) < 1e-12);
  }
  CHECK(seen[static_cast<std::size_t>(Meeting::inside)] > 50);
  CHECK(seen[static_cast<std::size_t>(Meeting::above)] > 50);
  CHECK(seen[static_cast<std::size_t>(Meeting::none)] > 50);
}
