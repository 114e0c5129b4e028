// SPDX-License-Identifier: Apache-2.0
// A node that slides along the top of a cube comes to its side a little below the edge.
#include "contact/detection/ledges.hpp"

#include <catch2/catch.hpp>

#include "few_faces.hpp"

using namespace brunt;
using support::FewFaces;

namespace {

const double ledge = test::tolerances().ledge;

FewFaces cube_met_by_a_corner() {
  FewFaces scene = support::cube();
  scene.facets = {Vec3(0, 0, -1), Vec3(1, 0, 0)};  // of the foot and the front of what comes along x
  return scene;
}

const Vec3 along_top(1, 0, 0);

}  // namespace

TEST_CASE("a side is passed over on a ledge, in front of it and just behind it, at any speed") {
  FewFaces scene = cube_met_by_a_corner();
  const double below = 1 - 0.5 * ledge;
  for (const double speed : {0.01, 1.0, 300.0}) {
    CHECK(scene.rows({-1e-3, 0.5, below}, speed * along_top).empty());
    const auto behind = scene.rows({1e-4, 0.5, below}, speed * along_top);
    REQUIRE(behind.size() == 1);
    CHECK(behind[0].normal.dot(Vec3(0, 0, 1)) > 0.999);
    CHECK(behind[0].gap == Approx(-0.5 * ledge));
  }
}

TEST_CASE("a higher step, and a side that is come upon from elsewhere, hold") {
  FewFaces scene = cube_met_by_a_corner();
  const auto is_held = [&](double z, const Vec3& velocity) {
    const auto rows = scene.rows({-1e-3, 0.5, z}, velocity);
    return rows.size() == 1 && rows[0].normal.dot(Vec3(-1, 0, 0)) > 0.999;
  };
  CHECK(is_held(1 - 3 * ledge, along_top));
  CHECK(is_held(1 - 0.5 * ledge, Vec3(1, 0, -1)));  // as much down as along
  CHECK(is_held(1 - 0.5 * ledge, Vec3::Zero()));
}

TEST_CASE("a flat front without a foot meets the side up to its edge") {
  FewFaces scene = support::cube();
  scene.facets = {Vec3(1, 0, 0)};
  CHECK(scene.rows({-1e-3, 0.5, 1 - 0.5 * ledge}, along_top).size() == 1);
}
