// SPDX-License-Identifier: Apache-2.0
// How many rows a node gets and along which normals, at edges, corners, grooves; who wins by each criterion.
#include "contact/detection/select_rows.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

#include "few_faces.hpp"

using namespace brunt;
using contact::Criterion;
using contact::Meeting;
using support::FewFaces;

TEST_CASE("on a cube a node never has more than one row, wherever it is and flies") {
  FewFaces scene = support::cube();
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> offset(-0.3, 1.3), unit(-1, 1);
  int met = 0;
  for (int shot = 0; shot < 20000; ++shot) {
    const Vec3 place(offset(engine), offset(engine), offset(engine));
    const Vec3 velocity = 300 * Vec3(unit(engine), unit(engine), unit(engine));
    const Vec3 facing = Vec3(unit(engine), unit(engine), unit(engine)).normalized();
    scene.facets = {facing};
    const auto rows = scene.rows(place, velocity);
    REQUIRE(rows.size() <= 1);
    met += static_cast<int>(rows.size());
  }
  CHECK(met > 1000);
}

TEST_CASE("in a plane a node has exactly one row along its normal, on nodes and edges of the mesh too") {
  FewFaces scene = support::flat();
  for (const double x : {0.0, 1e-16, -1e-12, 1e-9, 0.3})
    for (const double y : {0.0, -1e-16, 1e-12, 0.7})
      for (const double gap : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-3, -1e-3}) {
        const auto rows = scene.rows({x, y, gap});
        CAPTURE(x, y, gap);
        REQUIRE(rows.size() == 1);
        CHECK(rows[0].gap == Approx(gap).margin(1e-15));
        CHECK((rows[0].normal - Vec3::UnitZ()).norm() < 1e-14);
      }
}

TEST_CASE("at the bottom of a groove of 60 degrees a node has a row for each side") {
  FewFaces scene = support::two_slopes(60);
  const double half = std::numbers::pi / 6;
  for (const double height : {0.0, 1e-12, -1e-12, 1e-3, -1e-3, -1e-2}) {
    const auto rows = scene.rows({0, 0.5, height});
    CAPTURE(height);
    REQUIRE(rows.size() == 2);
    for (const contact::Row& row : rows) {
      CHECK(std::abs(row.normal.x()) == Approx(std::cos(half)));
      CHECK(row.normal.z() == Approx(std::sin(half)));
      CHECK(row.gap == Approx(height * std::sin(half)).margin(1e-15));
    }
    CHECK(rows[0].normal.x() * rows[1].normal.x() < 0);
  }
}

TEST_CASE("in the corner of a box a node has a row for each of three faces") {
  FewFaces scene = support::box_corner();
  for (const double inset : {1e-3, 0.0, 1e-12, -1e-12, -1e-3}) {
    CAPTURE(inset);
    const auto rows = scene.rows(Vec3::Constant(inset));
    REQUIRE(rows.size() == 3);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK((rows[static_cast<std::size_t>(axis)].normal - Vec3::Unit(axis)).norm() < 1e-14);
      CHECK(rows[static_cast<std::size_t>(axis)].gap == Approx(inset).margin(1e-15));
    }
  }
  CHECK(scene.rows({0.001, 0.001, 0.5}).size() == 2);  // along the edge x = y = 0, away from the bottom
}

TEST_CASE("a concave place asks for two rows where the normals differ by more than 20 degrees, a convex one never") {
  const auto rows_at = [](double degrees) {
    FewFaces scene = support::two_slopes(degrees);
    return scene.rows({0, 0.5, -1e-4}).size();
  };
  CHECK(rows_at(180 - 19) == 1);
  CHECK(rows_at(180 - 21) == 2);
  CHECK(rows_at(180 - 90) == 2);
  CHECK(rows_at(180 + 19) == 1);
  CHECK(rows_at(180 + 21) == 1);
  CHECK(rows_at(180 + 90) == 1);
}

TEST_CASE("on a ridge the normal is the mean of both sides' and does not jump with rounding") {
  for (const double bend : {1.0, 10.0, 40.0, 100.0}) {
    FewFaces scene = support::two_slopes(180 + bend);
    for (const double aside : {0.0, 1e-16, -1e-16, 1e-15, -1e-15}) {
      CAPTURE(bend, aside);
      const auto rows = scene.rows({aside, 0.5, -1e-12});
      REQUIRE(rows.size() == 1);
      CHECK((rows[0].normal - Vec3::UnitZ()).norm() < 1e-12);
    }
  }
}

TEST_CASE("inside a convex edge the normal turns from one face's to the other's without a jump") {
  FewFaces scene = support::two_slopes(270);
  const Vec3 right = Vec3(1, 0, 1).normalized(), left = Vec3(-1, 0, 1).normalized();
  Vec3 last = scene.rows(Vec3(0, 0.5, 0) - 0.012 * right)[0].normal;
  CHECK(last.x() < -0.3);
  for (double share = 0; share <= 1; share += 1.0 / 128) {  // just behind the left one at first, the right one at last
    const auto rows = scene.rows(Vec3(0, 0.5, 0) - 0.012 * ((1 - share) * right + share * left));
    CAPTURE(share);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].normal.dot(last) > std::cos(0.12));
    last = rows[0].normal;
  }
  CHECK(last.x() > 0.3);
}

TEST_CASE("a node at the height of one side of a ridge is not deep inside, though it is behind the other side") {
  for (const double bend : {1e-6, 1e-4, 1e-3, 5.0, 15.0, 19.0, 25.0}) {
    FewFaces scene = support::two_slopes(180 + bend);
    const Vec3 down = scene.motion[2].position, normal(-down.z(), 0, down.x());
    for (const double along : {0.005, 0.018})
      for (const double height : {1e-9, -1e-9}) {
        CAPTURE(bend, along, height);
        const auto rows = scene.rows(Vec3(0, 0.5, 0) + along * down + height * normal);
        REQUIRE(rows.size() == 1);
        CHECK(std::abs(rows[0].gap - height) < 1e-10);
      }
  }
}

// Heinstein et al. 2000, Fig. 8: a node inside a convex corner has two faces that compete; which it is pushed out of
// depends on the criterion.
TEST_CASE("criteria at a corner: the nearer face, the one more opposed, the one it came through") {
  FewFaces scene = support::cube();
  scene.facets = {Vec3(-0.6, 0, -0.8)};  // opposes the top more than the side
  const Vec3 inside(1 - 0.02, 0.5, 1 - 0.05);
  const auto winner = [&](Criterion criterion) {
    scene.settings.criterion = criterion;
    const auto rows = scene.rows(inside);
    REQUIRE(rows.size() == 1);
    return rows[0].normal;
  };
  CHECK((winner(Criterion::automatic) - Vec3::UnitX()).norm() < 1e-14);  // in contact: the smaller |gap|
  CHECK((winner(Criterion::nearest) - Vec3::UnitX()).norm() < 1e-14);
  CHECK((winner(Criterion::velocity) - Vec3::UnitX()).norm() < 1e-14);
  CHECK((winner(Criterion::strength) - Vec3::UnitZ()).norm() < 1e-14);  // 0.05 * 0.8 > 0.02 * 0.6
}

TEST_CASE("criteria for a node that comes: automatic and velocity take the face that its path crosses") {
  FewFaces scene = support::cube();
  scene.facets = {Vec3(-1, 0, -1).normalized()};
  const Vec3 outside(1.02, 0.5, 0.9);  // beside the side x = 1 and below the top
  for (const Criterion criterion : {Criterion::automatic, Criterion::velocity, Criterion::nearest}) {
    scene.settings.criterion = criterion;
    const auto rows = scene.rows(outside, {-100, 0, 0});
    REQUIRE(rows.size() == 1);
    CHECK((rows[0].normal - Vec3::UnitX()).norm() < 1e-12);
    CHECK(rows[0].gap == Approx(0.02));
  }
}

TEST_CASE("a node between two bodies keeps a row for each") {
  FewFaces scene({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 0.01), Vec3(1, 0, 0.01),
                  Vec3(1, 1, 0.01), Vec3(0, 1, 0.01)},
                 {{0, 1, 2, 3}, {4, 7, 6, 5}});
  scene.faces[1].body = 2;
  scene.facets = {Vec3(0, 0, -1), Vec3(0, 0, 1)};
  const auto rows = scene.rows({0.4, 0.5, 0.004});
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].gap == Approx(0.004));
  CHECK(rows[1].gap == Approx(0.006));
}
