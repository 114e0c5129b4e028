// SPDX-License-Identifier: Apache-2.0
// Two-sided faces: the gap is that to half the thickness on the node's side, and a node that is pressed through the
// middle is pushed back to where it came from.
#include "contact/detection/sides.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "few_faces.hpp"

using namespace brunt;
using contact::Row;
using support::FewFaces;

namespace {

constexpr double half = 0.05;

/// Four unit squares around the origin as a sheet; the slave's surface looks up and down.
FewFaces sheet() {
  FewFaces scene = support::flat();
  for (contact::MasterFace& face : scene.faces) {
    face.two_sided = true;
    face.half_thickness = half;
  }
  scene.facets = {Vec3(0, 0, -1), Vec3(0, 0, 1)};
  return scene;
}

/// The only row: its normal is along z.
void check_row(const std::vector<Row>& rows, double side, double gap) {
  REQUIRE(rows.size() == 1);
  CHECK((rows[0].normal - Vec3(0, 0, side)).norm() < 1e-14);
  CHECK(rows[0].gap == Approx(gap).margin(1e-14));
}

}  // namespace

TEST_CASE("a sheet holds nodes off on both sides at half its thickness") {
  FewFaces scene = sheet();
  check_row(scene.rows({0.3, 0.4, 0.15}), 1, 0.1);
  scene.history.clear();
  check_row(scene.rows({0.3, 0.4, -0.15}), -1, 0.1);
  scene.history.clear();
  check_row(scene.rows({0.3, 0.4, -0.02}), -1, -0.03);
  CHECK(scene.rows({0.3, 0.4, 0.31}).empty());  // a quarter of the edge, and half the thickness
  CHECK(scene.history.empty());
}

TEST_CASE("a node that lies on a sheet of its own keeps both half thicknesses") {
  FewFaces scene = sheet();
  scene.slave_thickness = 0.04;
  scene.facets = {Vec3(0, 0, 1)};  // a sheet looks to both sides
  check_row(scene.rows({0.3, 0.4, 0.15}), 1, 0.1 - 0.02);
  scene.history.clear();
  check_row(scene.rows({0.3, 0.4, -0.15}), -1, 0.1 - 0.02);
  scene.history.clear();
  scene.faces[3].two_sided = false;  // the skin of a solid that looks up
  scene.faces[3].half_thickness = 0;
  check_row(scene.rows({0.3, 0.4, 0.15}), 1, 0.15 - 0.02);
}

TEST_CASE("through the middle and back: the side stays while they meet, and is new after they parted") {
  for (const double side : {1.0, -1.0}) {
    FewFaces scene = sheet();
    for (const double height : {0.2, 0.06, 0.01, -0.03, -0.1, -0.2, -0.1, 0.04}) {
      check_row(scene.rows({0.3, 0.4, side * height}), side, height - half);
      REQUIRE(scene.history.size() == 1);  // of one face, though four are near
      CHECK(scene.history[0].side == side);
    }
    CHECK(scene.rows({0.3, 0.4, side * 0.4}).empty());
    check_row(scene.rows({0.3, 0.4, -side * 0.1}), -side, 0.1 - half);
  }
}

TEST_CASE("a node keeps its side while it slides from face to face, however these are turned") {
  for (const bool turned : {false, true}) {
    FewFaces scene = sheet();
    if (turned) std::swap(scene.faces[1].nodes[1], scene.faces[1].nodes[3]);
    scene.rows({-0.5, -0.5, 0.1});
    // pressed below the middle of the first face, over two edges to the fourth
    for (const Vec3& at :
         {Vec3(-0.1, -0.5, -0.02), Vec3(0.1, -0.5, -0.02), Vec3(0.5, -0.2, -0.02), Vec3(0.5, 0.1, -0.02)})
      check_row(scene.rows(at), 1, -0.02 - half);
  }
}

TEST_CASE("past the rim a node is free, and comes back on the other side") {
  FewFaces scene = sheet();
  check_row(scene.rows({0.9, 0.5, 0.05}), 1, 0);
  CHECK(scene.rows({1.1, 0.5, 0.04}).empty());
  CHECK(scene.history.empty());
  CHECK(scene.rows({1.1, 0.5, -0.06}).empty());
  check_row(scene.rows({0.9, 0.5, -0.06}), -1, 0.01);
}

TEST_CASE("paths through a sheet are met at its surface: 2000 shots from both sides, some from beside it") {
  FewFaces scene = sheet();
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> place(-0.95, 0.95), slant(-2, 2), far(0.06, 4);
  for (int shot = 0; shot < 2000; ++shot) {
    const double side = shot % 2 == 0 ? 1 : -1;
    const Vec3 direction(slant(engine), slant(engine), -side), target(place(engine), place(engine), side * half);
    const double before = far(engine), after = far(engine);
    scene.history.clear();
    CAPTURE(shot);
    const Vec3 velocity = (before + after) / scene.dt * direction;
    const std::vector<Row> rows = scene.rows(target - before * direction, velocity);
    check_row(rows, side, before);  // along z, the path's part of it has length 1
    REQUIRE_FALSE(scene.history.empty());
    for (const contact::HistoryRecord& record : scene.history) CHECK(record.side == side);
  }
}

TEST_CASE("a sheet that moves through a node meets it on the side that it comes from") {
  for (const double side : {1.0, -1.0}) {
    FewFaces scene = sheet();
    for (contact::NodeMotion& node : scene.motion) node.predicted = Vec3(0, 0, side * 2 / scene.dt);
    check_row(scene.rows({0.3, 0.4, side * 1}), side, 1 - half);
  }
}

TEST_CASE("a fold: beside a face its plane tells no side") {
  // two squares that meet in the y axis, one level to the right, one straight down; a node above the corner
  FewFaces scene({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, -1), Vec3(0, 1, -1)},
                 {{0, 1, 2, 3}, {0, 3, 5, 4}});
  for (contact::MasterFace& face : scene.faces) {
    face.two_sided = true;
    face.half_thickness = half;
  }
  scene.facets = {Vec3(0, 0, -1), Vec3(1, 0, 0)};
  check_row(scene.rows({0.1, 0.5, 0.06}), 1, 0.01);
  REQUIRE(scene.history.size() == 1);
  // over the edge and down: out of the second face, to the left, as the first face's side has it
  const std::vector<Row> rows = scene.rows({-0.06, 0.5, -0.1});
  REQUIRE(rows.size() == 1);
  CHECK((rows[0].normal + Vec3::UnitX()).norm() < 1e-14);
  CHECK(rows[0].gap == Approx(0.01).margin(1e-14));
}
