// SPDX-License-Identifier: Apache-2.0
// One slave facet's part of the rows: sums of weights, areas, the gap, and slopes against differences.
#include "contact/mortar/facet_rows.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "two_surfaces.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// One slave facet under several warped masters.
test::TwoSurfaces one_facet(bool triangles) {
  return {{1, 1, 0.1, 0.9, 0.1, 0.8, true, triangles},
          [](double x, double y) { return Vec3(x, y + 0.1 * x, 0.02 * x * y); },
          {3, 2, -0.2, 1.2, -0.1, 1.3, false, triangles},
          [](double x, double y) { return Vec3(x + 0.05 * y, y, 0.05 + 0.03 * x * x - 0.02 * y); }};
}

}  // namespace

TEST_CASE("facet rows: weights over slave and master cancel, shares are what is covered") {
  const bool triangles = GENERATE(false, true);
  const test::TwoSurfaces two = one_facet(triangles);
  FacetRows facet;
  REQUIRE(facet.evaluate(two.surfaces, 0, two.candidates.row(0), two.x, false));
  CHECK(facet.corners() == (triangles ? 3 : 4));
  double shares = 0, scale = facet.covered_area();
  for (std::size_t j = 0; j < facet.corners(); ++j) {
    double sum = 0, of_slave = 0;
    for (std::size_t node = 0; node < facet.nodes().size(); ++node) {
      sum += facet.weight(j, node);
      if (node < facet.corners()) of_slave += facet.weight(j, node);
    }
    CHECK(std::abs(sum) < 1e-15);
    CHECK(of_slave == Approx(facet.share(j)).epsilon(1e-13));
    shares += facet.share(j);
    CHECK(facet.gap_vector(j)[2] < 0);  // slave less master, which is above
  }
  CHECK(shares == Approx(scale).epsilon(1e-13));
  CHECK(facet.segments() >= 2);
}

TEST_CASE("facet rows: slopes of weights and of the covered area are their derivatives") {
  const bool triangles = GENERATE(false, true);
  test::TwoSurfaces two = one_facet(triangles);
  FacetRows facet, up, down;
  REQUIRE(facet.evaluate(two.surfaces, 0, two.candidates.row(0), two.x, true));
  constexpr double step = 1e-6;
  double worst = 0, worst_area = 0, largest = 0;
  for (std::size_t node = 0; node < facet.nodes().size(); ++node)
    for (int c = 0; c < 3; ++c) {
      Vec3& x = two.x[static_cast<std::size_t>(facet.nodes()[node])];
      const double at = x[c];
      x[c] = at + step;
      REQUIRE(up.evaluate(two.surfaces, 0, two.candidates.row(0), two.x, false));
      x[c] = at - step;
      REQUIRE(down.evaluate(two.surfaces, 0, two.candidates.row(0), two.x, false));
      x[c] = at;
      for (std::size_t j = 0; j < facet.corners(); ++j)
        for (std::size_t k = 0; k < facet.nodes().size(); ++k) {
          const double slope = facet.slope(j, k)[3 * node + static_cast<std::size_t>(c)];
          largest = std::max(largest, std::abs(slope));
          worst = std::max(worst, std::abs((up.weight(j, k) - down.weight(j, k)) / (2 * step) - slope));
        }
      worst_area = std::max(worst_area, std::abs((up.covered_area() - down.covered_area()) / (2 * step) -
                                                 facet.covered_area_slope(node)[c]));
    }
  CHECK(worst < 1e-8 * largest);  // M1 of reference-mortar.md
  CHECK(worst_area < 1e-8 * largest);
}

TEST_CASE("facet rows: nothing is covered where no master is") {
  const test::TwoSurfaces two = one_facet(false);
  FacetRows facet;
  CHECK_FALSE(facet.evaluate(two.surfaces, 0, {}, two.x, false));
}
