// SPDX-License-Identifier: Apache-2.0
// Integrals of one pair against the values of reference-mortar.md, M1, and exact ones; derivatives against differences.
#include "contact/mortar/segment.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "facet_pairs.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Corners;

namespace {

constexpr double anywhere = std::numeric_limits<double>::infinity();

bool integrate(const Corners& slave, const Corners& master, SegmentIntegrals& integrals,
               SegmentSlopes* slopes = nullptr, double capture = anywhere) {
  SlavePlane plane;
  return make_slave_plane(slave, plane) && integrate_segment(plane, master, capture, integrals, slopes);
}

/// int of N_A N_B over a whole triangle: area / 6 or / 12.
double triangle_mass(double area, std::size_t a, std::size_t b) {
  return area / (a == b ? 6 : 12);
}

Corners looking_down(Corners corners, double height) {
  std::reverse(corners.begin() + 1, corners.end());
  for (Vec3& x : corners) x[2] += height;
  return corners;
}

}  // namespace

TEST_CASE("Two turned squares have the integrals of the reference") {
  SegmentIntegrals integrals;
  REQUIRE(integrate(test::unit_square, test::turned_square(), integrals));
  CHECK(integrals.area == Approx(.6487266823562).epsilon(1e-12));
  CHECK(integrals.distance == Approx(.1).epsilon(1e-14));
  const double slave[4][4] = {{.0232374145554, .0324189848839, .0213078230111, .0203212839647},
                              {.0324189848839, .0882047184229, .0527851308803, .0213078230111},
                              {.0213078230111, .0527851308803, .1075764949528, .0443124662668},
                              {.0203212839647, .0213078230111, .0443124662668, .0448010303897}};
  const double master[4][4] = {{.0410566940104, .0368297531128, .0093646309058, .0100344283859},
                               {.0870995147828, .0444302001966, .0233085039373, .0398784382814},
                               {.0490316796783, .0734969934626, .0638219686221, .0396312733479},
                               {.0262957236044, .0674939063367, .0266029945565, .0103499791346}};
  const double share[4] = {.0972855064150, .1947166571981, .2259819151109, .1307426036322};
  for (std::size_t a = 0; a < 4; ++a) {
    double of_slave = 0, of_master = 0;
    for (std::size_t b = 0; b < 4; ++b) {
      CHECK(std::abs(integrals.slave[a][b] - slave[a][b]) < 1e-12);
      CHECK(std::abs(integrals.master[a][b] - master[a][b]) < 1e-12);
      of_slave += integrals.slave[a][b];
      of_master += integrals.master[a][b];
    }
    CHECK(std::abs(integrals.share[a] - share[a]) < 1e-12);
    CHECK(std::abs(of_slave - of_master) < 1e-15);
  }
}

TEST_CASE("Integrals do not depend on where the pair is") {
  SegmentIntegrals here, there;
  REQUIRE(integrate(test::unit_square, test::turned_square(), here));
  const Mat3 turn = (Mat3() << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6).finished();
  Corners slave = test::unit_square, master = test::turned_square();
  for (Corners* corners : {&slave, &master})
    for (Vec3& x : *corners) x = turn * x + Vec3(10, -20, 30);
  REQUIRE(integrate(slave, master, there));
  const auto first = test::products_of(here), second = test::products_of(there);
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(std::abs(first[i] - second[i]) < 1e-14);
}

TEST_CASE("Triangles have the integrals of linear functions") {
  const Corners triangle{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  SegmentIntegrals integrals;
  REQUIRE(integrate(triangle, looking_down(triangle, 0.2), integrals));
  CHECK(integrals.area == Approx(1).epsilon(1e-14));
  for (std::size_t a = 0; a < 3; ++a) {
    CHECK(integrals.share[a] == Approx(1.0 / 3).epsilon(1e-14));
    for (std::size_t b = 0; b < 3; ++b) {
      CHECK(integrals.slave[a][b] == Approx(triangle_mass(1, a, b)).epsilon(1e-13));
      CHECK(integrals.master[a][b == 0 ? 0 : 3 - b] == Approx(triangle_mass(1, a, b)).epsilon(1e-13));
    }
  }
  CHECK(integrals.slave[3][3] == 0);
  // A square over it covers the quadrilateral (0,0), (1,0), (1,.5), (0,1): N_0 = 1 - x/2 - y has the moment 7/24.
  REQUIRE(integrate(triangle, looking_down(test::unit_square, 0.2), integrals));
  CHECK(integrals.area == Approx(.75).epsilon(1e-14));
  CHECK(integrals.share[0] == Approx(7.0 / 24).epsilon(1e-14));
}

TEST_CASE("Over a tiling of the slave the integrals add up to those of the slave") {
  const Corners slave{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::array<std::array<double, 4>, 4> sum{};
  for (int j = -1; j < 3; ++j)
    for (int i = -1; i < 3; ++i) {
      const auto node = [](int k, int l) { return Vec3(0.4 * k + 0.1 * l + 0.05, 0.45 * l - 0.07 * k + 0.1, 0.1); };
      SegmentIntegrals integrals;
      if (!integrate(slave, {node(i, j), node(i, j + 1), node(i + 1, j + 1), node(i + 1, j)}, integrals)) continue;
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) sum[a][b] += integrals.slave[a][b];
    }
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b) {
      const double exact = a == b ? 1.0 / 9 : (a + b) % 2 == 0 ? 1.0 / 36 : 1.0 / 18;
      CHECK(sum[a][b] == Approx(exact).epsilon(1e-13));
    }
}

TEST_CASE("Facets that do not face each other, barely overlap or are too far apart have no segment") {
  SegmentIntegrals integrals;
  const Corners &slave = test::unit_square, master = looking_down(test::unit_square, 0.1);
  CHECK(integrate(slave, master, integrals, nullptr, 0.11));
  CHECK_FALSE(integrate(slave, master, integrals, nullptr, 0.09));
  CHECK(integrate(slave, looking_down(test::unit_square, -0.1), integrals, nullptr, 0.11));
  Corners upward = test::unit_square;
  CHECK_FALSE(integrate(slave, upward, integrals));
  Corners beside = master;
  for (Vec3& x : beside) x[0] += 1 - 1e-10;
  CHECK_FALSE(integrate(slave, beside, integrals));
  for (Vec3& x : beside) x[0] -= 1e-6;
  CHECK(integrate(slave, beside, integrals));
  CHECK_FALSE(integrate(Corners(4, Vec3::Zero()), master, integrals));
  CHECK_FALSE(integrate(slave, Corners(4, Vec3(0.5, 0.5, 0)), integrals));
}

TEST_CASE("Derivatives by all coordinates agree with central differences") {
  test::RandomPairs pairs(5);
  const double step = 1e-6;
  double worst = 0;
  int seen = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int slave_corners = trial % 3 == 1 ? 3 : 4, master_corners = trial % 4 == 1 ? 3 : 4;
    const test::FacetPair pair = pairs(slave_corners, master_corners);
    SegmentIntegrals integrals, plus, minus;
    SegmentSlopes slopes;
    if (!integrate(pair.slave, pair.master, integrals, &slopes)) continue;
    ++seen;
    for (std::size_t direction = 0; direction < 24; ++direction) {
      const bool of_slave = direction < 12;
      const std::size_t corner = direction % 12 / 3;
      if (corner >= (of_slave ? pair.slave : pair.master).size()) {
        for (std::size_t a = 0; a < 4; ++a) CHECK(slopes.master[a][0][direction] == 0);
        continue;
      }
      test::FacetPair moved = pair;
      double& x = (of_slave ? moved.slave : moved.master)[corner][static_cast<Eigen::Index>(direction % 3)];
      const double at = x;
      x = at + step;
      REQUIRE(integrate(moved.slave, moved.master, plus));
      x = at - step;
      REQUIRE(integrate(moved.slave, moved.master, minus));
      const auto high = test::products_of(plus), low = test::products_of(minus);
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) {
          const double slave = slopes.slave[SegmentSlopes::pair_of_corners(a, b)][direction];
          worst = std::max(worst, std::abs(slave - (high[4 * a + b] - low[4 * a + b]) / (2 * step)));
          const double master = slopes.master[a][b][direction];
          worst = std::max(worst, std::abs(master - (high[16 + 4 * a + b] - low[16 + 4 * a + b]) / (2 * step)));
        }
    }
  }
  CHECK(seen > 50);
  CHECK(worst < 1e-8 * 0.2);  // largest entries are about 0.2
}

TEST_CASE("A master that is not convex is integrated over its two triangles") {
  const Corners slave{{-1, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-1, 2, 0}};
  SegmentIntegrals integrals;
  REQUIRE(integrate(slave, {{0, 0, .1}, {0, 1, .1}, {.2, .2, .1}, {1, 0, .1}}, integrals));
  CHECK(integrals.area == Approx(0.2).epsilon(1e-14));
  double sum = 0;
  for (const auto& row : integrals.master)
    for (const double value : row) sum += value;
  CHECK(sum == Approx(integrals.area).epsilon(1e-14));
}

TEST_CASE("Integrals are continuous where corners of the overlap appear and vanish") {
  // General quadrilaterals, which the rule does not integrate exactly: with a fan around the mean of the corners the
  // integrals jump by its error, 1e-6, where a corner splits in two.
  Corners slave = test::unit_square, master = looking_down(test::unit_square, 0.1);
  slave[2] += Vec3(0.2, -0.15, 0);
  master[1] += Vec3(-0.1, 0.2, 0);
  SegmentIntegrals before, after;
  const double nothing = 1e-10;
  for (int corner = 0; corner < 4; ++corner) {  // each master corner passes through the slave's second side
    const Vec3 through = 0.3 * slave[1] + 0.7 * slave[2] + Vec3(0, 0, 0.1);
    Corners here = master;
    for (Vec3& x : here) x += through - master[static_cast<std::size_t>(corner)];
    Corners there = here;
    for (Vec3& x : here) x[0] -= nothing;
    for (Vec3& x : there) x[0] += nothing;
    const bool first = integrate(slave, here, before), second = integrate(slave, there, after);
    if (!first || !second) continue;
    const auto a = test::products_of(before), b = test::products_of(after);
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(std::abs(a[i] - b[i]) < 10 * nothing);
  }
}
