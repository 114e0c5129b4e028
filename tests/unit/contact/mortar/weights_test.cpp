// SPDX-License-Identifier: Apache-2.0
// Multiplier functions of partly covered facets: biorthogonal where most of the facet is covered, positive where little
// is, consistent at rims; their derivative against differences.
#include "contact/mortar/weights.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "facet_pairs.hpp"

using namespace brunt;
using namespace brunt::contact;
using Form = MultiplierFunctions::Form;

namespace {

SegmentIntegrals segment_of(const SlavePlane& plane, const test::Corners& master) {
  SegmentIntegrals integrals;
  REQUIRE(integrate_segment(plane, master, std::numeric_limits<double>::infinity(), integrals));
  return integrals;
}

/// Covers x from `from` to `to` of the unit square, beyond it in y; looks down.
test::Corners strip(double from, double to) {
  return {{from, -1, .1}, {from, 2, .1}, {to, 2, .1}, {to, -1, .1}};
}

}  // namespace

TEST_CASE("On a whole facet the dual functions are those of the line, crossed") {
  SlavePlane plane;
  REQUIRE(make_slave_plane(test::unit_square, plane));
  const std::vector<SegmentIntegrals> segments{segment_of(plane, strip(-1, 0.3)), segment_of(plane, strip(0.3, 2))};
  const MultiplierFunctions functions = multiplier_functions(plane, segments, Multiplier::dual);
  REQUIRE(functions.form == Form::dual);
  const double line[2][2] = {{2, -1}, {-1, 2}};  // A of a wholly covered edge
  const std::size_t at[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(functions.matrix[j][k] == Approx(line[at[j][0]][at[k][0]] * line[at[j][1]][at[k][1]]).epsilon(1e-12));
}

TEST_CASE("A strip has the dual functions of a partly covered edge, mixed with hats") {
  // M1 in two dimensions: an edge covered for x in [0.3, 1] by a master edge from 0.3 to 1.5.
  SlavePlane plane;
  REQUIRE(make_slave_plane(test::unit_square, plane));
  const std::vector<SegmentIntegrals> segments{segment_of(plane, strip(0.3, 1.5))};
  const MultiplierFunctions functions = multiplier_functions(plane, segments, Multiplier::dual);
  const double line[2][2] = {{3.971428571428571, -1.6}, {-2.971428571428571, 2.6}};
  const auto dual = [&](std::size_t j, std::size_t k) { return functions.share[j] * functions.inverse[j][k]; };
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(dual(j, k) == Approx(2 * line[j][k]).epsilon(1e-12));
      const double share =
          0.4 * 0.4 * (3 - 2 * 0.4);  // the cubic at .7, two fifths of the way from a half to the whole
      CHECK(functions.matrix[j][k] == Approx(share * dual(j, k) + (1 - share) * (j == k)).epsilon(1e-12));
    }
  // n_AC summed over both rows of nodes and both master nodes of an end.
  const auto ends = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    double sum = 0;
    for (const std::size_t row : {a, b})
      for (const std::size_t column : {c, d})
        for (std::size_t k = 0; k < 4; ++k) sum += dual(row, k) * segments[0].master[k][column];
    return sum;
  };
  CHECK(ends(0, 3, 0, 1) == Approx(.30625).epsilon(1e-12));
  CHECK(ends(0, 3, 2, 3) == Approx(-.06125).epsilon(1e-12));
  CHECK(ends(1, 2, 0, 1) == Approx(.1895833333333333).epsilon(1e-12));
  CHECK(ends(1, 2, 2, 3) == Approx(.2654166666666667).epsilon(1e-12));
  CHECK(functions.share[0] + functions.share[3] == Approx(.245).epsilon(1e-13));
  const MultiplierFunctions hats = multiplier_functions(plane, segments, Multiplier::standard);
  double corner = 0;
  for (const std::size_t j : {0, 3})
    for (const std::size_t k : {0, 3}) corner += hats.slave_weight(j, k);
  CHECK(corner == Approx(343.0 / 3000).epsilon(1e-12));
}

TEST_CASE("Rows of slave and master have equal sums, whatever the coverage") {
  SlavePlane plane;
  REQUIRE(make_slave_plane(test::unit_square, plane));
  for (const double width : {1.0, 0.8, 0.55, 0.1, 1e-2, 2e-3, 5e-4, 1e-5, 1e-7}) {
    const std::vector<SegmentIntegrals> segments{segment_of(plane, strip(1 - width, 2))};
    const MultiplierFunctions functions = multiplier_functions(plane, segments, Multiplier::dual);
    CHECK(functions.form == (width < 1e-6 ? Form::none : width > 0.5 ? Form::dual : Form::standard));
    if (functions.form == Form::none) continue;
    for (std::size_t j = 0; j < 4; ++j) {
      double sum = 0, size = 0, of_slave = 0;
      for (std::size_t k = 0; k < 4; ++k) of_slave += functions.slave_weight(j, k);
      for (std::size_t c = 0; c < 4; ++c) {
        sum += functions.master_weight(j, c, segments[0]);
        size += std::abs(functions.master_weight(j, c, segments[0]));
      }
      CHECK(std::abs(sum - of_slave) < 1e-14 * size);
      CHECK(std::abs(of_slave - functions.share[j]) < 1e-14 * size);
    }
  }
}

TEST_CASE("The derivative of the matrix is that of the product D M^-1") {
  SlavePlane plane;
  REQUIRE(make_slave_plane(test::unit_square, plane));
  std::vector<SegmentIntegrals> segments{segment_of(plane, test::turned_square())};
  const MultiplierFunctions functions = multiplier_functions(plane, segments, Multiplier::dual);
  std::array<std::array<double, 4>, 4> mass{};
  std::array<double, 4> share{};
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k) {
      mass[j][k] = 1e-2 * static_cast<double>((j + 1) * (k + 1) % 5);
      share[j] += mass[j][k];
    }
  const double area_slope = 0.7;
  const auto slope = matrix_slope(functions, share, mass, area_slope);
  REQUIRE(functions.dual_share_slope > 0.1);
  const auto at = [&](double step) {
    SlavePlane grown = plane;
    grown.twice_area += 2 * step * area_slope;
    std::vector<SegmentIntegrals> moved = segments;
    for (std::size_t j = 0; j < 4; ++j) {
      moved[0].share[j] += step * share[j];
      for (std::size_t k = 0; k < 4; ++k) moved[0].slave[j][k] += step * mass[j][k];
    }
    for (const double share_of : share) moved[0].area += step * share_of;
    return multiplier_functions(grown, moved, Multiplier::dual).matrix;
  };
  const auto plus = at(1e-5), minus = at(-1e-5);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(std::abs(slope[j][k] - (plus[j][k] - minus[j][k]) / 2e-5) < 1e-7 * 20);  // entries of A up to 20
}
