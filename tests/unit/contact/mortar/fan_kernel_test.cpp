// SPDX-License-Identifier: Apache-2.0
// The rule on one triangle of the fan: exact to degree five, slopes of products against differences.
#include <catch2/catch.hpp>
#include <cmath>

#include "contact/mortar/fan.hpp"

using namespace brunt;
using namespace brunt::contact;
using Point = geometry::PlanePoint<double>;

namespace {

constexpr std::array<Point, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
    other{{{-.2, -.1}, {1.3, 0}, {1.2, 1.4}, {0, 1}}};
constexpr std::array<Point, 3> corners{{{.4, .5}, {.1, .2}, {.8, .1}}};

double twice_area(const std::array<Point, 3>& p) {
  return (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
}

ProductSums sums_over(const std::array<Point, 3>& corner, const std::array<Point, 4>& slave, FanFunctions& functions) {
  ProductSums sums;
  add_products(FacetMap(slave), FacetMap(other), {corner, twice_area(corner)}, sums, functions);
  return sums;
}

}  // namespace

TEST_CASE("fan kernel: products of the square's functions are integrated exactly") {
  FanFunctions functions;
  const ProductSums sums = sums_over(corners, square, functions);
  // int x^2 y^2 over the triangle, by a midpoint sum in barycentric coordinates
  constexpr int n = 400;
  double whole = 0;
  const double cell = 0.5 * std::abs(twice_area(corners)) / (n * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j)
      for (int half = 0; half < (j < n - i - 1 ? 2 : 1); ++half) {
        const double a = (i + (half ? 2 : 1) / 3.0) / n, b = (j + (half ? 2 : 1) / 3.0) / n, c = 1 - a - b;
        const double x = c * corners[0].x + a * corners[1].x + b * corners[2].x,
                     y = c * corners[0].y + a * corners[1].y + b * corners[2].y;
        whole += cell * x * x * y * y;
      }
  const double sign = twice_area(corners) > 0 ? 1 : -1;
  CHECK(sign * sums[7] == Approx(whole).epsilon(1e-4));  // N_2 N_2, N_2 = x y; the sum's own error is 1e-5
}

TEST_CASE("fan kernel: functions sum to one, and so do their products") {
  FanFunctions functions;
  const ProductSums sums = sums_over(corners, square, functions);
  const double area = 0.5 * twice_area(corners);
  double slave = 0, master = 0;
  for (int a = 0, product = 0; a < 4; ++a) {
    for (int b = a; b < 4; ++b) slave += (a == b ? 1 : 2) * sums[product++];
    for (int c = 0; c < 4; ++c) master += sums[slave_products + 4 * a + c];
  }
  CHECK(slave == Approx(area).epsilon(1e-13));
  CHECK(master == Approx(area).epsilon(1e-13));
  for (int q = 0; q < fan_points; ++q) {
    double of_slave = 0;
    for (int a = 0; a < 4; ++a) of_slave += functions.value[a][q];
    CHECK(of_slave == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("fan kernel: slopes of products by the slave's corners, at points that stay") {
  FanFunctions functions, unused;
  (void)sums_over(corners, square, functions);
  FanTriangle<Sloped> triangle;  // its corners depend on nothing
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.corner[k].x.value = corners[k].x;
    triangle.corner[k].y.value = corners[k].y;
  }
  triangle.twice_area.value = twice_area(corners);
  std::array<ProductSlopes, slope_packs> slopes;
  for (int p = 0; p < slope_packs; ++p) add_product_slopes(triangle, functions, p, slopes[static_cast<std::size_t>(p)]);
  constexpr double step = 1e-6;
  for (int direction = 0; direction < 8; ++direction) {
    std::array<Point, 4> up = square, down = square;
    const auto k = static_cast<std::size_t>(direction / 2);
    (direction % 2 == 0 ? up[k].x : up[k].y) += step;
    (direction % 2 == 0 ? down[k].x : down[k].y) -= step;
    const ProductSums above = sums_over(corners, up, unused), below = sums_over(corners, down, unused);
    for (int product = 0; product < products; ++product) {
      const double slope = slopes[static_cast<std::size_t>(direction / pack_width)].of[product][direction % pack_width];
      CHECK(slope == Approx((above[product] - below[product]) / (2 * step)).margin(1e-10));
    }
  }
}
