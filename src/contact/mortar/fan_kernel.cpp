// SPDX-License-Identifier: Apache-2.0
#include "fan.hpp"

namespace brunt::contact {

namespace {

// The rule of degree five with seven points (Radon 1948): the centroid, and two orbits of three points.
constexpr double root15 = 3.872983346207417;
constexpr double near1 = (6 - root15) / 21, near2 = (6 + root15) / 21, far1 = 1 - 2 * near1, far2 = 1 - 2 * near2;
constexpr double weight1 = (155 - root15) / 1200, weight2 = (155 + root15) / 1200, third = 1.0 / 3;

/// Barycentric coordinates of the two last corners; weights of sum one. The eighth point fills the pack.
constexpr double first[fan_points] = {third, near1, far1, near1, near2, far2, near2, third};
constexpr double second[fan_points] = {third, near1, near1, far1, near2, near2, far2, third};
constexpr double weight[fan_points] = {9.0 / 40, weight1, weight1, weight1, weight2, weight2, weight2, 0};
constexpr int weighted_points = 7;

BRUNT_INLINE Pack load(const double* from) {
  Pack a;
  __builtin_memcpy(&a, from, sizeof a);
  return a;
}
BRUNT_INLINE void store(Pack a, double* to) {
  __builtin_memcpy(to, &a, sizeof a);
}

BRUNT_INLINE void keep(const ShapeFunctions& shape, int from, int points, FanFunctions& functions) {
  for (int a = 0; a < 4; ++a) {
    store(shape.value[a], functions.value[from + a] + points);
    store(shape.by_x[a], functions.by_x[from + a] + points);
    store(shape.by_y[a], functions.by_y[from + a] + points);
  }
}

/// Derivatives of shape functions `from` to `from + 3` at a point that moves by (x, y) relative to the facet.
BRUNT_INLINE void function_slopes(const FanFunctions& functions, int from, int q, Pack x, Pack y, Pack (&slopes)[4]) {
  for (int a = 0; a < 4; ++a) slopes[a] = functions.by_x[from + a][q] * x + functions.by_y[from + a][q] * y;
}

/// If a facet's corners move in the directions of pack p, a fixed point moves by -N_k relative to the facet.
BRUNT_INLINE void move_corners(const FanFunctions& functions, int from, int q, int p, Pack& x, Pack& y) {
  constexpr int packs_a_facet = slope_packs / 2, corners_a_pack = pack_width / 2;
  if (p / packs_a_facet != from / 4) return;
  const int corner = from + p % packs_a_facet * corners_a_pack;
  Pack shift_x{}, shift_y{};
  for (int k = 0; k < corners_a_pack; ++k) {
    shift_x[2 * k] = functions.value[corner + k][q];
    shift_y[2 * k + 1] = functions.value[corner + k][q];
  }
  x -= shift_x;
  y -= shift_y;
}

}  // namespace

void add_products(const FacetMap& slave, const FacetMap& master, const FanTriangle<double>& triangle, ProductSums& sums,
                  FanFunctions& functions) {
  const auto [centre, corner, next] = triangle.corner;
  for (int points = 0; points < fan_points; points += pack_width) {
    const Pack to_corner = load(first + points), to_next = load(second + points);
    const Pack x = centre.x + to_corner * (corner.x - centre.x) + to_next * (next.x - centre.x);
    const Pack y = centre.y + to_corner * (corner.y - centre.y) + to_next * (next.y - centre.y);
    ShapeFunctions of_slave, of_master;
    shape_functions(slave, x, y, of_slave);
    shape_functions(master, x, y, of_master);
    const Pack area = 0.5 * triangle.twice_area * load(weight + points);
    int product = 0;
    for (int a = 0; a < 4; ++a) {
      const Pack of_a = area * of_slave.value[a];
      for (int b = a; b < 4; ++b) sums.sum[product++] += of_a * of_slave.value[b];
      for (int c = 0; c < 4; ++c) sums.sum[slave_products + 4 * a + c] += of_a * of_master.value[c];
    }
    keep(of_slave, 0, points, functions);
    keep(of_master, 4, points, functions);
  }
}

void add_product_slopes(const FanTriangle<Sloped>& triangle, const FanFunctions& functions, int p,
                        ProductSlopes& slopes) {
  const auto& [centre, corner, next] = triangle.corner;
  const double twice_area = triangle.twice_area.value;
  for (int q = 0; q < weighted_points; ++q) {
    const double to_corner = first[q], to_next = second[q], to_centre = 1 - to_corner - to_next;
    const Pack x = to_centre * centre.x.slope[p] + to_corner * corner.x.slope[p] + to_next * next.x.slope[p];
    const Pack y = to_centre * centre.y.slope[p] + to_corner * corner.y.slope[p] + to_next * next.y.slope[p];
    Pack slave_x = x, slave_y = y, master_x = x, master_y = y, of_slave[4], of_master[4];
    move_corners(functions, 0, q, p, slave_x, slave_y);
    move_corners(functions, 4, q, p, master_x, master_y);
    function_slopes(functions, 0, q, slave_x, slave_y, of_slave);
    function_slopes(functions, 4, q, master_x, master_y, of_master);
    const double area = 0.5 * weight[q] * twice_area;
    const Pack area_slope = 0.5 * weight[q] * triangle.twice_area.slope[p];
    Pack whole[8];  // of area times the function: slave, master
    for (int a = 0; a < 4; ++a) {
      of_slave[a] = area * of_slave[a];
      whole[a] = of_slave[a] + functions.value[a][q] * area_slope;
      whole[4 + a] = area * of_master[a] + functions.value[4 + a][q] * area_slope;
    }
    int product = 0;
    for (int a = 0; a < 4; ++a) {
      const double value = functions.value[a][q];
      for (int b = a; b < 4; ++b) slopes.of[product++] += functions.value[b][q] * of_slave[a] + value * whole[b];
      for (int c = 0; c < 4; ++c)
        slopes.of[slave_products + 4 * a + c] += functions.value[4 + c][q] * of_slave[a] + value * whole[4 + c];
    }
  }
}

}  // namespace brunt::contact
