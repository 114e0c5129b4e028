// SPDX-License-Identifier: Apache-2.0
// Multiplier functions of partly covered facets: biorthogonal, consistent at rims, lumped where nearly nothing is
// covered; their derivative against differences.
#include "brunt/contact/mortar/weights.hpp"

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

TEST_CASE("A strip has the functions of a partly covered edge") {
  // M1 in two dimensions: an edge covered for x in [0.3, 1] by a master edge from 0.3 to 1.5.
  SlavePlane plane;
  REQUIRE(make_slave_plane(test::unit_square, plane));
  const std::vector<SegmentIntegrals> segments{segment_of(plane, strip(0.3, 1.5))};
  const MultiplierFunctions functions = multiplier_functions(plane, segments, Multiplier::dual);
  const double line[2][2] = {{3.971428571428571, -1.6}, {-2.971428571428571, 2.6}};
  CHECK(functions.matrix[0][0] == Approx(2 * line[0][0]).epsilon(1e-12));
  CHECK(functions.matrix[0][1] == Approx(2 * line[0][1]).epsilon(1e-12));
  CHECK(functions.matrix[1][0] == Approx(2 * line[1][0]).epsilon(1e-12));
  CHECK(functions.matrix[1][1] == Approx(2 * line[1][1]).epsilon(1e-12));
  // n_AC summed over both rows of nodes and both master nodes of an end.
  const auto ends = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    double sum = 0;
    for (const std::size_t row : {a, b})
      for (const std::size_t column : {c, d}) sum += functions.master_weight(row, column, segments[0]);
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
  for (const double width : {1.0, 0.1, 1e-2, 2e-3, 5e-4, 1e-5, 1e-7}) {
    const std::vector<SegmentIntegrals> segments{segment_of(plane, strip(1 - width, 2))};
    const MultiplierFunctions functions = multiplier_functions(plane, segments, Multiplier::dual);
    CHECK(functions.form == (width < 1e-6 ? Form::none : width < 1e-3 ? Form::lumped : Form::dual));
    if (functions.form == Form::none) continue;
    for (std::size_t j = 0; j < 4; ++j) {
      double sum = 0, size = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        sum += functions.master_weight(j, c, segments[0]);
        size += std::abs(functions.master_weight(j, c, segments[0]));
      }
      // rounding of A grows with its entries, 1 / width^2
      CHECK(std::abs(sum - functions.slave_weight(j, j)) < 1e-15 * (1 + 1 / (width * width)) * size);
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
  const auto slope = matrix_slope(functions, share, mass);
  const auto at = [&](double step) {
    std::vector<SegmentIntegrals> moved = segments;
    for (std::size_t j = 0; j < 4; ++j) {
      moved[0].share[j] += step * share[j];
      for (std::size_t k = 0; k < 4; ++k) moved[0].slave[j][k] += step * mass[j][k];
    }
    return multiplier_functions(plane, moved, Multiplier::dual).matrix;
  };
  const auto plus = at(1e-5), minus = at(-1e-5);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(std::abs(slope[j][k] - (plus[j][k] - minus[j][k]) / 2e-5) < 1e-7 * 20);  // entries of A up to 20
}
