// SPDX-License-Identifier: Apache-2.0
// Closest points at the borders of the regions, and on degenerate, warped and very thin faces (case E18).
#include <catch2/catch.hpp>
#include <limits>

#include "geometry/closest_point.hpp"
#include "shots.hpp"

using brunt::Vec3;
using namespace brunt::geometry;
using namespace brunt::geometry::testing;

namespace {

/// Smallest distance over a dense grid, each of whose local minima is refined by ever finer grids around it.
double dense_distance(const Vec3& x, Corners corners) {
  constexpr int n = 24;
  const auto distance = [&](double xi, double eta) {
    return (x - point_at(corners, std::clamp(xi, -1.0, 1.0), std::clamp(eta, -1.0, 1.0))).norm();
  };
  const auto at = [&](int i, int j) { return distance(2.0 * i / n - 1, 2.0 * j / n - 1); };
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double here = at(i, j);
      if (here > std::min({at(i + 1, j), at(i - 1, j), at(i, j + 1), at(i, j - 1)})) continue;
      double xi = 2.0 * i / n - 1, eta = 2.0 * j / n - 1, least = here;
      for (double spacing = 1.0 / n; spacing > 1e-9; spacing *= 0.7) {
        const double centre_xi = xi, centre_eta = eta;
        for (int a = -2; a <= 2; ++a) {
          for (int b = -2; b <= 2; ++b) {
            const double p = std::clamp(centre_xi + a * spacing, -1.0, 1.0),
                         q = std::clamp(centre_eta + b * spacing, -1.0, 1.0), d = distance(p, q);
            if (d < least) {
              least = d;
              xi = p;
              eta = q;
            }
          }
        }
      }
      best = std::min(best, least);
    }
  }
  return best;
}

void compare_with_dense(const std::array<Vec3, 4>& quad, int places, double reach, unsigned seed) {
  Random random(seed);
  double worst = 0;
  for (int i = 0; i < places; ++i) {
    const Vec3 x = 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]) + random_vector(random, reach);
    const auto found = closest_point(x, quad);
    REQUIRE(found);
    REQUIRE(found->point.allFinite());
    REQUIRE((found->point - point_at(quad, found->xi, found->eta)).norm() < 1e-12 * (1 + reach));
    worst = std::max(worst, (x - found->point).norm() - dense_distance(x, quad));
  }
  CHECK(worst < 1e-9);
}

}  // namespace

TEST_CASE("regions of a rectangle change where they should, to 1e-12") {
  const std::array<Vec3, 4> quad{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
  constexpr double e = 1e-12, reach = 1 + 2 * face_tolerance;
  const auto region = [&](double x, double y) { return closest_point({x, y, 0.5}, quad)->region; };
  // from edge to vertex: the planes through the vertices across the edges
  CHECK(region(1 - e, -2) == Region::edge0);
  CHECK(region(1 + e, -2) == Region::vertex1);
  CHECK(region(-1 + e, -2) == Region::edge0);
  CHECK(region(-1 - e, -2) == Region::vertex0);
  CHECK(region(2, 1 - e) == Region::edge1);
  CHECK(region(2, 1 + e) == Region::vertex2);
  CHECK(region(-1 + e, 2) == Region::edge2);
  CHECK(region(-1 - e, 2) == Region::vertex3);
  CHECK(region(-2, -1 + e) == Region::edge3);
  CHECK(region(-2, -1 - e) == Region::vertex0);
  // from face to edge: at the tolerance
  CHECK(region(reach - e, 0.3) == Region::face);
  CHECK(region(reach + e, 0.3) == Region::edge1);
  CHECK(region(0.3, reach - e) == Region::face);
  CHECK(region(0.3, reach + e) == Region::edge2);
  CHECK(region(-reach + e, 0.3) == Region::face);
  CHECK(region(-reach - e, 0.3) == Region::edge3);
  CHECK(region(0.3, -reach + e) == Region::face);
  CHECK(region(0.3, -reach - e) == Region::edge0);
  CHECK(region(reach + e, reach + e) == Region::vertex2);
  CHECK(region(1 + e, 1 + e) == Region::face);
}

TEST_CASE("regions of a triangle change where they should, to 1e-12") {
  const std::array<Vec3, 3> triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  constexpr double e = 1e-12;
  const auto region = [&](double x, double y) { return closest_point({x, y, -0.5}, triangle)->region; };
  CHECK(region(e, -1) == Region::edge0);
  CHECK(region(-e, -1) == Region::vertex0);
  CHECK(region(1 - e, -1) == Region::edge0);
  CHECK(region(1 + e, -1) == Region::vertex1);
  CHECK(region(-1, 1 - e) == Region::edge2);
  CHECK(region(-1, 1 + e) == Region::vertex2);
  CHECK(region(2 - e, 1) == Region::edge1);  // the plane across edge 1 through vertex 1 is y = x - 1
  CHECK(region(2 + 4 * e, 1) == Region::vertex1);
  CHECK(region(0.3, -face_tolerance + e) == Region::face);
  CHECK(region(0.3, -face_tolerance - e) == Region::edge0);
  CHECK(region(-face_tolerance + e, 0.3) == Region::face);
  CHECK(region(-face_tolerance - e, 0.3) == Region::edge2);
  CHECK(region(0.5, 0.5 + face_tolerance - e) == Region::face);
  CHECK(region(0.5, 0.5 + face_tolerance + e) == Region::edge1);
}

TEST_CASE("a quadrilateral warped by 45 degrees: as near as a dense search finds, from anywhere") {
  const std::array<Vec3, 4> quad{Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(1, 1, 0), Vec3(0, 1, 1)};
  compare_with_dense(quad, 1500, 0.4, 1);
  compare_with_dense(quad, 1500, 2, 2);
}

TEST_CASE("random strongly warped quadrilaterals: as near as a dense search finds") {
  Random random(12);
  for (unsigned i = 0; i < 300; ++i) compare_with_dense(random_face(random, 4, 0.5, 0, 0).start, 8, 1.5, i);
}

TEST_CASE("quadrilaterals with duplicate nodes: as near as a dense search finds") {
  compare_with_dense({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 1, 0)}, 60, 1, 3);
  compare_with_dense({Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0.2), Vec3(0, 1, 0)}, 60, 1, 4);
}

TEST_CASE("a needle 1 : 10^4: as near as a dense search finds") {
  const std::array<Vec3, 4> flat{Vec3(0, 0, 0), Vec3(1e4, 0, 0), Vec3(1e4, 1, 0), Vec3(0, 1, 0)};
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 x(between(random, -10, 1.001e4), between(random, -1, 2), between(random, -2, 2));
    const Vec3 nearest(std::clamp(x.x(), 0.0, 1e4), std::clamp(x.y(), 0.0, 1.0), 0);
    const auto found = closest_point(x, flat);
    REQUIRE(found);
    CHECK((found->point - nearest).norm() < 1e-9);
  }
  compare_with_dense({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1e-4, 1e-5), Vec3(0, 1e-4, 0)}, 60, 0.6, 7);
}

TEST_CASE("faces without area are refused: collinear, of one point, folded flat") {
  const Vec3 x(0.3, 0.2, 1);
  CHECK_FALSE(closest_point(x, std::array{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2), Vec3(3, 3, 3)}));
  CHECK_FALSE(closest_point(x, std::array{Vec3(0, 0, 0), Vec3(2, 2, 2), Vec3(1, 1, 1), Vec3(3, 3, 3)}));
  CHECK_FALSE(closest_point(x, std::array{Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0)}));
  CHECK_FALSE(closest_point(x, std::array{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}));
  CHECK_FALSE(closest_point(x, std::array{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(3, 0, 0)}));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(closest_point(x, std::array{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(nan, 1, 0)}));
  CHECK_FALSE(closest_point(x, std::array{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(infinity, 1, 0)}));
}
