// SPDX-License-Identifier: Apache-2.0
// Moments of closed surfaces against bricks and against table D of the reference values (pawn, mallet, L).
#include "rigid/surface_moments.hpp"

#include <catch2/catch.hpp>

#include "tests/support/depth_bodies.hpp"

using namespace brunt;

TEST_CASE("a box far from the origin has the moments of a box") {
  const Vec3 low(1000, -2000, 500), size(1, 2, 3);
  const auto body = rigid::surface_properties(test::box(low, low + size), 5);
  CHECK(body.mass == Approx(30).epsilon(1e-11));
  CHECK((body.centre - (low + 0.5 * size)).norm() < 1e-10);
  const Mat3 exact = Vec3(4 + 9, 9 + 1, 1 + 4).asDiagonal() * Mat3(Mat3::Identity() * (30.0 / 12));
  CHECK((body.inertia - exact).norm() < 1e-9);
}

TEST_CASE("a cavity counts negative") {
  TriangleSurface shell = test::box({-2, -2, -2}, {2, 2, 2});
  const TriangleSurface hole = test::box({-1, -1, -1}, {1, 1, 1});
  const auto first = static_cast<LocalIndex>(shell.points.size());
  shell.points.insert(shell.points.end(), hole.points.begin(), hole.points.end());
  for (const auto& t : hole.triangles) shell.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  const auto body = rigid::surface_properties(shell, 1);
  CHECK(body.mass == Approx(64 - 8).epsilon(1e-13));
  CHECK(body.inertia(0, 0) == Approx(64 * 32. / 12 - 8 * 8. / 12).epsilon(1e-13));
}

TEST_CASE("volumes, centroids and J of table D") {
  struct Line {
    TriangleSurface surface;
    double volume, xx, yy, zz, xy, z;
  };
  const Line lines[] = {{test::l_shape(), 1.020000, .347950, .347950, .654233, .169550, .25},
                        {test::pawn(), .598163, .393120, .393120, .079499, 0, .735006},
                        {test::mallet(), 1.570142, .971907, .783119, .247097, 0, 3.063899}};
  for (const Line& line : lines) {
    const auto body = rigid::surface_properties(line.surface, 1);
    const Mat3 J = body.inertia / body.mass;
    CHECK(body.mass == Approx(line.volume).margin(1e-6));
    CHECK(J(0, 0) == Approx(line.xx).margin(1e-6));
    CHECK(J(1, 1) == Approx(line.yy).margin(1e-6));
    CHECK(J(2, 2) == Approx(line.zz).margin(1e-6));
    CHECK(J(0, 1) == Approx(line.xy).margin(5e-5));  // quadrilaterals cut one way are not quite symmetric
    CHECK(body.centre[2] == Approx(line.z).margin(1e-6));
  }
  CHECK(rigid::surface_properties(test::knot(), 1).mass == Approx(10.334392).margin(1e-6));
  CHECK(rigid::surface_properties(test::hub(), 1).mass == Approx(5.628048).margin(1e-6));
  CHECK(rigid::surface_properties(test::bumpy_sphere(), 1).mass == Approx(14.142815).margin(1e-6));
}
