// SPDX-License-Identifier: Apache-2.0
// Nodes beside sharp edges: far behind the plane of one face, but outside, or come in through the other.
#include "contact/detection/features.hpp"

#include <catch2/catch.hpp>

#include "few_faces.hpp"

using namespace brunt;
using namespace brunt::contact;
using support::FewFaces;

namespace {

/// A block of 2 x 1 x 1 elements with its faces at z = 1 (top), x = 0 and x = 2 left out; its side is y = 1.
FewFaces bar() {
  std::vector<Vec3> points;
  for (const double z : {0.0, 1.0})
    for (const double y : {0.0, 1.0})
      for (const double x : {0.0, 1.0, 2.0}) points.emplace_back(x, y, z);
  return {points, {{0, 3, 4, 1}, {1, 4, 5, 2}, {3, 9, 10, 4}, {4, 10, 11, 5}}};  // two below, two at the side y = 1
}

}  // namespace

TEST_CASE("a node just outside of a side is not deep behind the face below, nor behind the one next to that") {
  for (const double height : {1e-9, 1e-6, 1e-3})
    for (const double depth : {0.05, 0.15, 0.24})
      for (const double x : {0.2, 0.9, 0.99}) {
        FewFaces scene = bar();
        scene.facets = {Vec3(0.1, -0.6, 0.7)};                                    // opposes both
        for (const std::size_t i : {3, 9}) scene.motion[i].position.y() += 1e-3;  // as if a blow had dented the middle
        const double side = 1 + 1e-3 * (1 - x);
        const auto rows = scene.rows(Vec3(x, side + height, depth));
        CAPTURE(height, depth, x);
        for (const Row& row : rows) CHECK(row.gap > -1e-4);
      }
}

TEST_CASE("a node that its surface hardly turns to a side is outside all the same, once it is clear of it") {
  FewFaces scene = bar();
  for (const double opposition : {0.0, 0.05, 0.17}) {
    scene.facets = {Vec3(0, -opposition, 1)};
    CAPTURE(opposition);
    for (const Row& row : scene.rows(Vec3(0.5, 1.01, 0.15))) CHECK(row.gap > 0);
  }
}

TEST_CASE("a node well outside of a side is not behind a face around the corner, even if it is less deep there") {
  FewFaces scene = bar();
  scene.facets = {Vec3(0, -0.7, 0.7)};
  for (const double x : {0.5, 0.8, 0.9})
    for (const Row& row : scene.rows(Vec3(x, 1.12, 0.1))) CHECK(row.gap > 0);
}

TEST_CASE("a node beyond the end of a bore is not inside of the wall, though it is behind the bore's facets") {
  FewFaces scene = support::two_slopes(150);  // two facets of a bore along y, which ends at y = 1
  scene.facets = {Vec3(0, -0.7, -0.7)};
  const Vec3 slope = scene.motion[2].position, into(slope.z(), 0, -slope.x());
  for (const double depth : {0.05, 0.1, 0.2})
    for (const double along : {0.3, 0.02}) CHECK(scene.rows(Vec3(0, 1.17, 0) + along * slope + depth * into).empty());
}

TEST_CASE("a node that came in through a side is as deep as it is there") {
  FewFaces scene = bar();
  for (const double opposition : {0.15, 0.5, 1.0}) {
    scene.facets = {Vec3(0, -opposition, 1)};
    const auto rows = scene.rows(Vec3(0.5, 1 - 1e-5, 0.15));
    CAPTURE(opposition);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].gap == Approx(-1e-5));
    CHECK(rows[0].normal.y() == Approx(1));
  }
}

TEST_CASE("where sides are flush to rounding, the depth below is true") {
  for (const double sideways : {0.0, 1e-16, -1e-16, 1e-9, -1e-9}) {
    FewFaces scene = bar();
    scene.facets = {Vec3(0, 0, 1), Vec3(0, 1, 0)};  // a block below, overlapping
    const auto rows = scene.rows(Vec3(0.5, 1 + sideways, 0.05));
    CAPTURE(sideways);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].gap == Approx(-0.05));
    CHECK(rows[0].normal.z() == Approx(-1));
  }
}

TEST_CASE("in a groove both sides hold, however deep the node is behind either") {
  FewFaces scene = support::two_slopes(90);
  const auto rows = scene.rows(Vec3(0, 0.5, -0.05));
  CHECK(rows.size() == 2);
  scene = support::two_slopes(90);
  const auto uneven = scene.rows(Vec3(0.08, 0.5, 0.08 - 0.01));  // behind one by 0.007, above the other
  REQUIRE_FALSE(uneven.empty());
  CHECK(uneven[0].gap == Approx(-0.01 * std::sqrt(0.5)));
}

TEST_CASE("at a corner the angles of its faces decide whether a node is outside") {
  FewFaces scene = support::cube();
  scene.facets = {Vec3(-1, -1, -1).normalized()};
  for (const Row& row : scene.rows(Vec3(1.001, 1.002, 1.003))) CHECK(row.gap > 0);
  for (const Row& row : scene.rows(Vec3(1.001, 0.9, 0.9))) CHECK(row.gap > 0);
  const auto inside = scene.rows(Vec3(0.999, 0.9, 0.95));
  REQUIRE(inside.size() == 1);
  CHECK(inside[0].gap == Approx(-0.001));
}

TEST_CASE("a node beyond a rim is not in a pit at a corner in the middle of it, whichever faces are within reach") {
  // two elements side by side, twice as high as wide: the faces below reach less far than those at the side y = 1
  FewFaces scene = bar();
  for (NodeMotion& node : scene.motion) node.position.z() *= 2;
  for (const auto& facets : {std::vector{Vec3(0, -0.7, 0.7)}, std::vector{Vec3(0.1, -0.9, 0.3), Vec3(-0.1, -0.3, 0.9)}})
    for (const double below : {0.03, 0.1, 0.2, 0.26, 0.3, 0.4})
      for (const double depth : {0.01, 0.1, 0.2, 0.3})
        for (const double x : {1 - 1e-3, 1 - 1e-9, 1.0, 1 + 1e-9, 1 + 1e-3}) {
          scene.facets = facets;
          CAPTURE(below, depth, x);
          for (const Row& row : scene.rows(Vec3(x, 1 - depth, -below))) CHECK(row.gap > 0);
        }
}
