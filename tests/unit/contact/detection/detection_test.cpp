// SPDX-License-Identifier: Apache-2.0
// Which rows a node gets, on faces, edges and corners of a cube and on walls.
#include "contact/detection/detection.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "support/tolerances.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// The unit cube as master (contact nodes 0-7, numbered as a hex8) and one slave node (8) of another body whose
/// surface has the facets given.
struct CubeAndNode {
  std::vector<MasterFace> faces;
  std::vector<GlobalIndex> gid{0, 1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<NodeMotion> motion;
  std::vector<Vec3> facets;
  Candidates candidates;
  DetectionSettings settings{.tolerances = &brunt::test::tolerances()};

  CubeAndNode() {
    constexpr std::array<std::array<LocalIndex, 4>, 6> sides{
        {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
    for (std::size_t f = 0; f < 6; ++f) faces.push_back({.key = static_cast<GlobalIndex>(f), .nodes = sides[f]});
    for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 1),
                          Vec3(1, 1, 1), Vec3(0, 1, 1)})
      motion.push_back({.position = x});
    motion.emplace_back();
    facets = {Vec3(0, 0, -1)};
    candidates.slave = {8};
    candidates.body = {1};
    candidates.faces.values = {0, 1, 2, 3, 4, 5};
    candidates.faces.close_row();
  }

  std::vector<Row> detect(const Vec3& position, const Vec3& velocity = Vec3::Zero(), double dt = 1e-3) {
    motion[8] = {position, velocity, velocity};
    candidates.slave_facets.clear();
    for (std::size_t f = 0; f < facets.size(); ++f)
      candidates.slave_facets.values.push_back(static_cast<LocalIndex>(f));
    candidates.slave_facets.close_row();
    std::vector<Row> rows;
    DetectionScratch scratch;
    detect_faces({gid, motion, dt, settings}, {candidates, faces, facets, {}}, scratch, rows);
    return rows;
  }
};

constexpr GlobalIndex top = 5;

}  // namespace

TEST_CASE("a node above a face: gap, normal, weights and right-hand side") {
  CubeAndNode scene;
  const auto rows = scene.detect({0.25, 0.5, 1.1});
  REQUIRE(rows.size() == 1);
  const Row& row = rows[0];
  CHECK(row.key.master == top);
  CHECK(row.key.slave == 8);
  CHECK(row.gap == Approx(0.1).epsilon(1e-12));
  CHECK(row.required == Approx(-0.1 / 1e-3).epsilon(1e-12));
  CHECK((row.normal - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(row.node_count == 5);
  Vec3 moment = Vec3::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    sum += row.weights[i];
    moment += row.weights[i] * scene.motion[static_cast<std::size_t>(row.nodes[i])].position;
  }
  CHECK(std::abs(sum) < 1e-15);                    // no momentum
  CHECK(moment.cross(row.normal).norm() < 1e-14);  // no moment
}

TEST_CASE("an accepted overlap is the zero of its node's gaps with that body only") {
  CubeAndNode scene;
  scene.settings.accepted = {{7, 0, 0.3}, {8, 0, 0.02}, {8, 3, 0.4}, {9, 0, 0.5}};
  auto rows = scene.detect({0.5, 0.5, 1 - 0.02});
  REQUIRE(rows.size() == 1);
  CHECK(std::abs(rows[0].gap) < 1e-15);
  CHECK(std::abs(rows[0].required) < 1e-12);  // left where it is
  rows = scene.detect({0.5, 0.5, 1 - 0.015});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].gap == Approx(0.005).epsilon(1e-9));
  CHECK(rows[0].required == Approx(-0.005 / 1e-3).epsilon(1e-9));  // may come back to it
  rows = scene.detect({0.5, 0.5, 1 - 0.021});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].gap == Approx(-0.001).epsilon(1e-9));
  CHECK(rows[0].required == Approx(0.05 * 0.001 / 1e-3).epsilon(1e-9));
  scene.settings.accepted = {{7, 0, 0.3}, {8, 3, 0.4}};
  CHECK(scene.detect({0.5, 0.5, 1 - 0.02}).at(0).gap == Approx(-0.02).epsilon(1e-9));
}

TEST_CASE("a penetration is recovered at a limited rate") {
  CubeAndNode scene;
  auto rows = scene.detect({0.5, 0.5, 1 - 1e-3});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].gap == Approx(-1e-3).epsilon(1e-9));
  CHECK(rows[0].required == Approx(0.05 * 1e-3 / 1e-3).epsilon(1e-9));
  rows = scene.detect({0.5, 0.5, 0.9});
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].required == Approx(1e-3 / 1e-3));
  CHECK(scene.detect({0.5, 0.5, 0.7}).empty());  // deeper than the capture: not this face's business
}

// At a share of the depth in each step bodies would be shot out of each other where steps are short.
TEST_CASE("a penetration is recovered no faster than the slower body's elements feel it, however short the step") {
  CubeAndNode scene;
  const double depth = 2e-3, edge = 1, dt = 1e-3;
  for (const double sound : {1e4, 1e3, 200.0, 10.0}) {
    CAPTURE(sound);
    scene.settings.sound = {sound, 300 * sound};
    CHECK(scene.detect({0.5, 0.5, 1 - depth}).at(0).required ==
          Approx(0.05 * depth / std::max(dt, 0.5 * edge / sound)).epsilon(1e-9));
  }
}

TEST_CASE("of nodes, which sink in by what each step leaves, a penetration is recovered under load as well") {
  CubeAndNode scene;
  scene.settings.recovery_gives = false;
  CHECK(scene.detect({0.5, 0.5, 1 - 2e-3}).front().required == Approx(0.05 * 2e-3 / 1e-3));
}

TEST_CASE("of fitted bodies, nodes deeper than what counts as touching are parted no faster than they came together") {
  CubeAndNode scene;
  scene.settings.fitted = {{0, 0}, {0, 1}, {1, 1}};
  for (const double depth : {2e-4, 1e-3, 2e-2})
    for (const double speed : {-0.02, 0.0, 3e-3, 5.0}) {
      CAPTURE(depth, speed);
      const double recovery = std::min(0.05 * depth, 1e-3) / 1e-3;
      CHECK(scene.detect({0.5, 0.5, 1 - depth}, {0, 0, -speed}).at(0).required ==
            Approx(std::clamp(speed, 0.0, recovery)).margin(1e-12));
    }
  CHECK(scene.detect({0.5, 0.5, 1 - 5e-5}).at(0).required == Approx(0.05 * 5e-5 / 1e-3));  // a drift
  scene.settings.fitted = {{0, 0}, {1, 1}, {0, 2}};
  CHECK(scene.detect({0.5, 0.5, 1 - 2e-3}).at(0).required == Approx(0.05 * 2e-3 / 1e-3));
}

TEST_CASE("what cannot touch in this step makes no row, what comes fast does") {
  CubeAndNode scene;
  CHECK(scene.detect({0.5, 0.5, 1.3}).empty());
  CHECK(scene.detect({0.5, 0.5, 1.3}, {0, 0, -100}).size() == 1);
  CHECK(scene.detect({0.5, 0.5, 1.3}, {0, 0, 100}).empty());
}

TEST_CASE("a corner on a corner meets the opposed face, not the sides, whatever the lateral offset") {
  CubeAndNode scene;
  scene.facets = {Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, 1, 0)};  // the corner of a cube standing on this one
  for (const double offset : {0.0, 1e-16, 1e-9, 1e-4, 1e-2, -1e-9, -1e-3}) {
    for (const double gap : {0.0, 1e-12, -1e-12, 1e-3, -1e-3}) {
      const auto rows = scene.detect({1 + offset, 1 + offset, 1 + gap});
      REQUIRE(rows.size() == 1);
      CHECK(rows[0].key.master == top);
      CHECK(rows[0].gap == Approx(gap).margin(1e-15));
      CHECK((rows[0].normal - Vec3::UnitZ()).norm() < 1e-14);
    }
  }
}

TEST_CASE("a flat surface at right angles to a face, but for a little tilt, has nothing to do with it") {
  CubeAndNode scene;
  for (const double tilt : {1e-15, 1e-3, 0.09}) {
    scene.facets = {Vec3(-tilt, 0, 1).normalized()};
    CHECK(scene.detect({1.01, 0.5, 1}).empty());
  }
  scene.facets = {Vec3(-0.2, 0, 1).normalized()};
  CHECK(scene.detect({1.01, 0.5, 1}).size() == 1);
  scene.facets = {Vec3(-0.05, 0, 1).normalized(), Vec3(-0.05, 0, -1).normalized()};  // of a blade
  CHECK(scene.detect({1.01, 0.5, 1}).size() == 1);
}

TEST_CASE("a node that flies at a convex edge is met once, along the mean of the two normals; one that passes is not") {
  CubeAndNode scene;
  scene.facets = {Vec3(-1, 0, -1).normalized()};
  CHECK(scene.detect({1.1, 0.5, 1.1}).empty());  // near, at rest
  for (const double aside : {0.0, 1e-12, 1e-9, 1e-6, -1e-6}) {
    const auto rows = scene.detect({1.1 + aside, 0.5, 1.1}, {-150, 0, -150});
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].gap == Approx(0.1 * std::sqrt(2.0)).epsilon(1e-5));
    CHECK((rows[0].normal - Vec3(1, 0, 1).normalized()).norm() < 1e-12);
  }
  CHECK(scene.detect({1.1, 0.5, 1.1}, {0, 0, -150}).empty());
  const auto aimed = scene.detect({1.1, 0.5, 1.05}, {-150, 0, -150});  // under the edge: the side alone
  REQUIRE(aimed.size() == 1);
  CHECK(aimed[0].key.master == 1);
  CHECK((aimed[0].normal - Vec3::UnitX()).norm() < 1e-12);
}

TEST_CASE("a face seen from behind is no master: a slave under a thin body does not jump through it") {
  CubeAndNode scene;
  scene.facets = {Vec3(0, 0, 1)};  // the slave's surface looks up
  CHECK(scene.detect({0.5, 0.5, 1.05}).empty());
  const auto below = scene.detect({0.5, 0.5, -0.05});
  REQUIRE(below.size() == 1);
  CHECK(below[0].key.master == 4);
}

TEST_CASE("a longer list of candidates changes nothing") {
  CubeAndNode scene;
  const auto expected = scene.detect({0.3, 0.6, 1.01});
  scene.candidates.faces.clear();
  scene.candidates.faces.values = {5};
  scene.candidates.faces.close_row();
  const auto shorter = scene.detect({0.3, 0.6, 1.01});
  REQUIRE(expected.size() == 1);
  REQUIRE(shorter.size() == 1);
  CHECK(shorter[0].key.master == expected[0].key.master);
  CHECK(shorter[0].gap == expected[0].gap);
  CHECK(shorter[0].weights == expected[0].weights);
}

TEST_CASE("rigid walls") {
  const std::vector<GlobalIndex> gid{4, 2};
  std::vector<NodeMotion> motion(2);
  motion[0] = {Vec3(0, 0, 0.5), Vec3(0, 0, -600), Vec3(0, 0, -600)};
  motion[1] = {Vec3(3, 1, -0.01), Vec3::Zero(), Vec3::Zero()};
  std::vector<Wall> walls{{.velocity = Vec3(7, 0, 2)}};
  std::vector<WallCandidate> candidates{{0, 0, 0, false}, {1, 0, 0, false}};
  DetectionSettings settings{.tolerances = &brunt::test::tolerances()};
  settings.wall_size = 1;
  std::vector<Row> rows;

  detect_walls({gid, motion, 1e-3, settings}, candidates, walls, rows);
  RowSortScratch scratch;
  sort_rows(rows, scratch);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].key.slave == 2);
  CHECK(rows[0].is_wall());
  CHECK(rows[0].key.master == 0);
  CHECK(rows[0].required == Approx(2 + 0.05 * 0.01 / 1e-3));
  CHECK(rows[1].required == Approx(2 - 0.5 / 1e-3));
  CHECK(rows[1].cone == Cone::compression);

  rows.clear();
  walls[0].bilateral = true;
  candidates[0].held = true;
  motion[0].position.z() = 10;  // far, but it belongs to the plane
  detect_walls({gid, motion, 1e-3, settings}, candidates, walls, rows);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].cone == Cone::free);
  CHECK(rows[0].required == Approx(2 - 1e-3 / 1e-3));
  CHECK(rows[1].cone == Cone::compression);

  rows.clear();
  motion[1].position.z() = 0.3;
  candidates.erase(candidates.begin());
  detect_walls({gid, motion, 1e-3, settings}, candidates, walls, rows);
  CHECK(rows.empty());
}

TEST_CASE("a node behind more than half of a flat element is not held: it belongs to a body on the far side") {
  CubeAndNode scene;
  CHECK(scene.detect({0.25, 0.5, 0.8}).size() == 1);
  for (MasterFace& face : scene.faces) face.element_depth = 0.1;
  CHECK(scene.detect({0.25, 0.5, 0.8}).empty());
  CHECK(scene.detect({0.25, 0.5, 0.96}).size() == 1);
}
