// SPDX-License-Identifier: Apache-2.0
// Edge against edge: crossing bars, flush bodies, steps that jump across.
#include "contact/detection/edges.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "support/tolerances.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// The lower edge (of a bar that stands on one edge, along x) and the upper (along x turned by `angle` about z, its
/// sharp side below); faces of both fall off at 45 degrees.
struct TwoEdges {
  std::vector<GlobalIndex> gid{0, 1, 2, 3};
  std::vector<NodeMotion> motion{4};
  std::vector<Vec3> facets;
  std::vector<NodeHold> holds{4};
  std::vector<Vec3> reference;
  EdgeCandidates candidates;
  DetectionSettings settings{.tolerances = &brunt::test::tolerances()};
  double dt = 1e-3;

  explicit TwoEdges(double degrees, double gap, double speed = 0) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 along(std::cos(angle), std::sin(angle), 0), across(-along.y(), along.x(), 0);
    motion[0].position = {-0.5, 0, 0};
    motion[1].position = {0.5, 0, 0};
    motion[2].position = -0.5 * along + Vec3(0, 0, gap);
    motion[3].position = 0.5 * along + Vec3(0, 0, gap);
    for (std::size_t i = 2; i < 4; ++i) motion[i].predicted = Vec3(0, 0, -speed);
    facets = {Vec3(0, 1, 1).normalized(), Vec3(0, -1, 1).normalized(), (across - Vec3::UnitZ()).normalized(),
              (-across - Vec3::UnitZ()).normalized()};
    candidates.masters = {{.nodes = {0, 1}, .facets = {0, 1}, .body = 0}};
    candidates.slaves = {{.nodes = {2, 3}, .facets = {2, 3}, .body = 1}};
    candidates.near.values = {0};
    candidates.near.close_row();
  }
  std::vector<Row> rows() {
    std::vector<Row> found;
    detect_edges({gid, motion, dt, settings}, {candidates, facets, holds, reference}, found);
    return found;
  }
};

}  // namespace

TEST_CASE("crossed edges at 90 degrees and at 1 degree: gap, normal, weights where they cross") {
  for (const double degrees : {90.0, 30.0, 1.0})
    for (const double gap : {1e-2, 1e-9, 0.0, -1e-9, -1e-2}) {
      CAPTURE(degrees, gap);
      TwoEdges edges(degrees, gap);
      const auto rows = edges.rows();
      REQUIRE(rows.size() == 1);
      const Row& row = rows[0];
      CHECK(row.is_edge());
      CHECK(row.gap == Approx(gap).margin(1e-14));
      CHECK((row.normal - Vec3::UnitZ()).norm() < 1e-10);
      const std::array<double, 4> expected{0.5, 0.5, -0.5, -0.5};
      for (std::size_t i = 0; i < 4; ++i) CHECK(row.weights[i] == Approx(expected[i]).margin(1e-9));
      CHECK((row.key.slave == 2 && row.key.slave_second == 3 && row.key.master == 0 && row.key.master_second == 1));
    }
}

TEST_CASE("edges that jump across each other within a step are met at the time they cross") {
  for (const double degrees : {90.0, 1.0})
    for (const double speed : {110.0, 1e3, 1e6}) {  // 0.11 to 1000 edge lengths a step
      CAPTURE(degrees, speed);
      const auto rows = TwoEdges(degrees, 0.1, speed).rows();
      REQUIRE(rows.size() == 1);
      CHECK(rows[0].gap == Approx(0.1).epsilon(1e-9));
      CHECK((rows[0].normal - Vec3::UnitZ()).norm() < 1e-9);
    }
  CHECK(TwoEdges(90, 0.1, 90).rows().empty());    // would arrive after the step
  CHECK(TwoEdges(90, 0.1, -1e3).rows().empty());  // departs
}

TEST_CASE("nearly parallel edges push along the middle of their faces' normals, however they tilt") {
  for (const double slope : {0.0, 0.01, -0.02}) {  // their common perpendicular turns by up to 49 degrees
    TwoEdges edges(1, -1e-4);
    edges.motion[2].position.z() -= 0.5 * slope;
    edges.motion[3].position.z() += 0.5 * slope;
    const auto rows = edges.rows();
    CAPTURE(slope);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].normal.z() > std::cos(0.06));
    CHECK(rows[0].gap == Approx(-1e-4).epsilon(0.01));
    CHECK(rows[0].weights[1] == Approx(0.5).margin(1e-3));
  }
}

TEST_CASE("an edge nearly along a chain that is dented at the crossing is not lost between the chain's edges") {
  TwoEdges edges(1, -1e-3);
  edges.motion.push_back({.position = Vec3(0, 0, 0)});  // the master's edge in two halves that rise to both ends
  edges.gid.push_back(4);
  edges.holds.emplace_back();
  edges.motion[0].position.z() = edges.motion[1].position.z() = 5e-3;
  for (const double x : {-1.0, 1.0})  // faces tilt with their edges
    for (const double y : {1.0, -1.0}) edges.facets.push_back(Vec3(-x * 0.01, y, 1).normalized());
  edges.candidates.masters = {{.nodes = {0, 4}, .facets = {4, 5}, .body = 0},
                              {.nodes = {1, 4}, .facets = {6, 7}, .body = 0}};
  edges.candidates.near.values = {0, 1};
  edges.candidates.near.offsets = {0, 2};
  for (const double shift : {0.0, 1e-7, -1e-6, 1e-5, -1e-4, 1e-3}) {
    TwoEdges moved = edges;
    for (std::size_t i : {2, 3}) moved.motion[i].position.x() += shift;
    CAPTURE(shift);
    CHECK_FALSE(moved.rows().empty());
  }
}

TEST_CASE("an edge that passes just beyond the end of another meets it where a node is pressed in, not far below") {
  const auto rows = [](double depth, double beyond) {
    TwoEdges edges(90, -depth);
    for (std::size_t i = 2; i < 4; ++i) edges.motion[i].position.x() += beyond > 0 ? 0.5 + beyond : 0;
    return edges.rows().size();
  };
  CHECK(rows(0.01, 0) == 1);
  CHECK(rows(0.01, 0.004) == 1);
  CHECK(rows(0.1, 0) == 1);
  CHECK(rows(0.1, 0.04) == 0);  // beside the body: nothing is inside it
}

// A corner that pressed into a rim lost the row of its edge in every fifth step, and sank by 3 % of an edge each time.
TEST_CASE("edges in touch are held though their normal is a little beyond that of a face, which may be warped") {
  const auto rows = [](double beyond_degrees, double gap) {
    TwoEdges edges(90, gap);
    const double angle = beyond_degrees * std::numbers::pi / 180;
    edges.facets[0] = Vec3(0, -std::sin(angle), std::cos(angle));  // the other one falls off at 45 degrees
    return edges.rows().size();
  };
  for (const double gap : {-0.01, -1e-4, 0.0, 1e-4}) {
    CAPTURE(gap);
    CHECK(rows(0, gap) == 1);
    CHECK(rows(5, gap) == 1);
    CHECK(rows(10, gap) == 0);
  }
  CHECK(rows(0, -0.03) == 1);
  CHECK(rows(5, -0.03) == 0);
}

TEST_CASE("edges that are deep when they are seen are parted no faster than they came together") {
  for (const double speed : {-0.02, 0.0, 0.03, 1.0}) {
    TwoEdges edges(90, -0.01, speed);
    edges.settings.recovery_gives = false;
    for (NodeMotion& node : edges.motion) node.old_velocity = node.predicted;
    const auto rows = edges.rows();
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].required == Approx(std::clamp(speed, 0.0, 0.05 * 0.01 / 1e-3)).margin(1e-12));
  }
  TwoEdges drifted(90, -2e-5);
  drifted.settings.recovery_gives = false;
  CHECK(drifted.rows().front().required == Approx(0.05 * 2e-5 / 1e-3));
}

TEST_CASE("parallel flush edges give no row: their faces and nodes do the work") {
  for (const double gap : {0.0, 1e-16, -1e-12, 1e-3}) {
    TwoEdges edges(0, gap);
    CHECK(edges.rows().empty());
  }
}

TEST_CASE("an edge that lies on a table has no row at the table's rim, one that hangs over it or slants does") {
  TwoEdges edges(90, 0);
  edges.facets = {Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(0, 0, -1), Vec3(1, 0, 0)};
  const NodeHold on_top{Vec3::UnitZ(), 0};
  edges.holds[2] = edges.holds[3] = on_top;
  CHECK(edges.rows().empty());  // both ends have rows on the table
  edges.holds[3].body = 5;
  CHECK(edges.rows().size() == 1);  // one end lies on another table, which may be lower
  edges.holds[2].body = 5;
  CHECK(edges.rows().size() == 1);
  edges.holds[2] = on_top;
  edges.holds[3] = {Vec3(0, -1, 0), 0};
  CHECK(edges.rows().size() == 1);  // one end is off the table and may sink: the rim holds the edge between them
  edges.holds[3].normal = Vec3(0, std::sin(0.2), std::cos(0.2));
  CHECK(edges.rows().size() == 1);  // 11 degrees: the edge is deeper at the rim than at its end
  edges.holds[3] = {};
  edges.motion[2].position = Vec3(0, -0.005, 0);
  CHECK(edges.rows().empty());  // the end that lies on the table lies at its rim and holds the edge there
}

TEST_CASE("edges that look the same way have nothing to do with each other, edges that have passed each other do") {
  TwoEdges edges(90, 0.01);
  std::copy(edges.facets.begin(), edges.facets.begin() + 2, edges.facets.begin() + 2);  // both bodies lie below
  CHECK(edges.rows().empty());
  TwoEdges passed(90, -0.01);
  REQUIRE(passed.rows().size() == 1);
  CHECK(passed.rows()[0].gap == Approx(-0.01));
}

TEST_CASE("an overlap of the start that is accepted is where the gap begins, for edges of which an end has one") {
  const auto gap = [](double at_start, double now, double turn, GlobalIndex accepted_node, std::int32_t body) {
    const TwoEdges before(70, at_start);
    TwoEdges edges(70, now);
    for (const NodeMotion& node : before.motion) edges.reference.push_back(node.position);
    const Eigen::AngleAxisd rotation(turn, Vec3(1, 2, 3).normalized());
    for (NodeMotion& node : edges.motion) node.position = rotation * node.position;
    for (Vec3& facet : edges.facets) facet = rotation * facet;
    edges.settings.accepted = {{accepted_node, body, 0.03}};
    const auto rows = edges.rows();
    REQUIRE(rows.size() == 1);
    return rows[0].gap;
  };
  for (const double turn : {0.0, 2.0})
    for (const auto& [node, body] : {std::pair<GlobalIndex, std::int32_t>{0, 1}, {1, 1}, {2, 0}, {3, 0}}) {
      CHECK(gap(-0.02, -0.02, turn, node, body) == Approx(0).margin(1e-14));
      CHECK(gap(-0.02, -0.03, turn, node, body) == Approx(-0.01).margin(1e-14));
      CHECK(gap(-0.02, 0.01, turn, node, body) == Approx(0.03).margin(1e-14));
      CHECK(gap(0.02, -0.01, turn, node, body) == Approx(-0.01).margin(1e-14));  // they were apart
    }
  CHECK(gap(-0.02, -0.02, 0, 2, 5) == Approx(-0.02).margin(1e-14));  // against another body
}

namespace {

/// The upper edge of a block's side (slave, along y) and the upright edge of another block (master) that slides towards
/// it along x, its foot a little below; far: how far off it is.
struct UprightAtLedge {
  std::vector<GlobalIndex> gid{0, 1, 2, 3, 4};
  std::vector<NodeMotion> motion{5};
  std::vector<Vec3> facets{Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  std::vector<NodeHold> holds{5};
  EdgeCandidates candidates;
  DetectionSettings settings{.tolerances = &brunt::test::tolerances()};

  UprightAtLedge(double far, double below) {
    motion[0].position = {0, -0.5, 0};
    motion[1].position = {0, 0.5, 0};
    motion[2].position = {-far, 0.1, -below};
    motion[3].position = {-far, 0.1, 1};
    for (std::size_t i = 2; i < 5; ++i) motion[i].old_velocity = Vec3(1, 0, 0);
    candidates.slaves = {{.nodes = {0, 1}, .facets = {0, 1}, .body = 0}};
    candidates.masters = {{.nodes = {2, 3}, .facets = {2, 3}, .body = 1}};
    candidates.near.values = {0};
  }
  /// Lists the edge that goes on from the foot, down by `length`.
  void go_on(double length) {
    motion[4].position = motion[2].position - Vec3(0, 0, length);
    candidates.masters.push_back({.nodes = {2, 4}, .facets = {2, 3}, .body = 1});
    candidates.near.values.push_back(1);
  }
  std::vector<Row> rows() {
    candidates.near.close_row();
    std::vector<Row> found;
    detect_edges({gid, motion, 1e-3, settings}, {candidates, facets, holds}, found);
    return found;
  }
};

}  // namespace

TEST_CASE("an upright edge passes over a ledge with its foot, not where it goes on or the step is higher") {
  CHECK(UprightAtLedge(1e-4, 5e-4).rows().empty());
  CHECK(UprightAtLedge(1e-4, 5e-3).rows().size() == 1);
  UprightAtLedge long_edge(1e-4, 5e-4);
  long_edge.go_on(1);
  CHECK(long_edge.rows().size() == 1);
}

TEST_CASE("an edge that is listed but out of reach does not tell whether another one goes on") {
  UprightAtLedge alone(0.1, 5e-4), listed(0.1, 5e-4);
  listed.go_on(0.01);  // so short that its reach ends before the slave edge
  CHECK(listed.rows().size() == alone.rows().size());
  UprightAtLedge high(0.1, 5e-3);  // there is something to pass over
  CHECK(high.rows().size() == 1);
}
