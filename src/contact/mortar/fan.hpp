// SPDX-License-Identifier: Apache-2.0
// Integrals of products of shape functions over a convex polygon, and their derivatives in the plane.
#pragma once
#include <array>

#include "facet_map.hpp"
#include "sloped.hpp"

namespace brunt::contact {

/// Products: ten of two slave functions (SegmentSlopes::pair_of_corners), then sixteen 4 A + C of slave and master.
constexpr int slave_products = 10, products = slave_products + 16;

/// A triangle of the fan: centre, corner, next corner; with derivatives on request.
template <class Number>
struct FanTriangle {
  std::array<geometry::PlanePoint<Number>, 3> corner{};
  Number twice_area{};
};

/// Points of the rule in each triangle: seven, of degree five, and one without weight to fill a pack.
constexpr int fan_points = 8, point_packs = fan_points / pack_width;

/// Shape functions at the points of one triangle, one point in each column.
struct alignas(64) FanFunctions {
  double value[8][fan_points];  ///< four of the slave, four of the master
  double by_x[8][fan_points], by_y[8][fan_points];
};

struct ProductSums {
  Pack sum[products]{};
  [[nodiscard]] double operator[](int product) const {
    double all = 0;
    for (int lane = 0; lane < pack_width; ++lane) all += sum[product][lane];
    return all;
  }
};

/// Adds the integrals over one triangle.
void add_products(const FacetMap& slave, const FacetMap& master, const FanTriangle<double>& triangle, ProductSums& sums,
                  FanFunctions& functions);

/// Derivatives of each product by the directions of one pack.
struct ProductSlopes {
  Pack of[products]{};
};

/// Adds the derivatives over one triangle by the directions of pack `p`.
void add_product_slopes(const FanTriangle<Sloped>& triangle, const FanFunctions& functions, int p,
                        ProductSlopes& slopes);

}  // namespace brunt::contact
