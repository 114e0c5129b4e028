// SPDX-License-Identifier: Apache-2.0
// A rim that crosses an edge between two faces of one plane.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "contact/detection/edges.hpp"
#include "support/tolerances.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// A flat edge along x on top of a plate, and a rim above it, along x turned about z, of a bar that stands on it.
struct RimOnPlate {
  std::vector<GlobalIndex> gid{0, 1, 2, 3};
  std::vector<NodeMotion> motion{4};
  std::vector<Vec3> facets;
  std::vector<NodeHold> holds{4};
  EdgeCandidates candidates;
  DetectionSettings settings{.tolerances = &brunt::test::tolerances()};
  double dt = 1e-3;

  /// at: where the rim crosses the flat edge, from -0.5 to 0.5.
  RimOnPlate(double degrees, double gap, double speed = 0, double at = 0.1) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 along(std::cos(angle), std::sin(angle), 0), across(-along.y(), along.x(), 0), middle(at, 0, gap);
    motion[0].position = {-0.5, 0, 0};
    motion[1].position = {0.5, 0, 0};
    motion[2].position = middle - 2 * along;
    motion[3].position = middle + 2 * along;
    for (std::size_t i = 2; i < 4; ++i) motion[i].predicted = Vec3(0, 0, -speed);
    facets = {Vec3::UnitZ(), Vec3::UnitZ(), (across - Vec3::UnitZ()).normalized(), -Vec3::UnitZ()};
    candidates.masters = {{.nodes = {0, 1}, .facets = {0, 1}, .body = 0, .flat = true}};
    candidates.slaves = {{.nodes = {2, 3}, .facets = {2, 3}, .body = 1}};
    candidates.near.values = {0};
    candidates.near.close_row();
  }
  std::vector<Row> rows() {
    std::vector<Row> found;
    detect_edges({gid, motion, dt, settings}, {candidates, facets, holds}, found);
    return found;
  }
};

}  // namespace

TEST_CASE("a rim across a flat edge: gap and normal of the plate, weights where they cross, either one as slave") {
  for (const double degrees : {90.0, 45.0, -30.0})
    for (const double gap : {1e-3, 0.0, -1e-2}) {
      CAPTURE(degrees, gap);
      RimOnPlate scene(degrees, gap);
      const auto rows = scene.rows();
      REQUIRE(rows.size() == 1);
      CHECK(rows[0].gap == Approx(gap).margin(1e-14));
      CHECK((rows[0].normal - Vec3::UnitZ()).norm() < 1e-14);
      const std::array<double, 4> expected{0.5, 0.5, -0.4, -0.6};
      for (std::size_t i = 0; i < 4; ++i) CHECK(rows[0].weights[i] == Approx(expected[i]).margin(1e-12));

      std::swap(scene.candidates.slaves, scene.candidates.masters);
      const auto swapped = scene.rows();
      REQUIRE(swapped.size() == 1);
      CHECK(swapped[0].gap == Approx(gap).margin(1e-14));
      CHECK((swapped[0].normal + Vec3::UnitZ()).norm() < 1e-14);
    }
}

TEST_CASE("a rim that jumps through a flat edge within the step is met where it crosses") {
  CHECK(RimOnPlate(90, 0.1, 90).rows().empty());  // would arrive after the step
  const auto rows = RimOnPlate(90, 0.1, 400).rows();
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].gap == Approx(0.1));
  CHECK((rows[0].normal - Vec3::UnitZ()).norm() < 1e-14);
}

TEST_CASE("rims hang over flat edges by a thousandth, and leave them to rims at the end that stands on one") {
  const double sag = 1e-3;  // of the flat edge, which is the shorter one
  CHECK(RimOnPlate(90, 0).rows()[0].required == Approx(-sag / 1e-3));
  CHECK(RimOnPlate(90, -sag).rows()[0].required == Approx(0).margin(1e-12));
  CHECK(RimOnPlate(15, -1e-2).rows().empty());  // that rim crosses others
  CHECK(RimOnPlate(90, -0.4).rows().empty());   // from the other side of the plate
  for (const double at : {-0.49, 0.49}) {
    RimOnPlate scene(90, -1e-2, 0, at);
    CHECK(scene.rows().size() == 1);
    scene.candidates.masters[0].end_on_rim = {0, 1};
    CHECK(scene.rows().size() == (at < 0 ? 1 : 0));
    scene.candidates.masters[0].end_on_rim = {1, 0};
    CHECK(scene.rows().size() == (at < 0 ? 0 : 1));
  }
}

TEST_CASE("a rim whose faces do not look at the plate does not press it") {
  RimOnPlate scene(90, -1e-2);
  scene.facets[2] = Vec3::UnitX();
  scene.facets[3] = Vec3(1, 0, 1).normalized();
  CHECK(scene.rows().empty());
}
