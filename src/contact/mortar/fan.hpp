// SPDX-License-Identifier: Apache-2.0
// Integrals of products of shape functions over a convex polygon, and their derivatives in the plane.
#pragma once
#include <array>

#include "core/simd.hpp"
#include "facet_map.hpp"

namespace brunt::contact {

/// A number and its derivatives by the sixteen coordinates of two facets in a plane.
constexpr int plane_directions = 16;  ///< 2 corner + axis: four corners of the slave, then four of the master
constexpr int slope_packs = plane_directions / pack_width;

struct Sloped {
  double value = 0;
  Pack slope[slope_packs]{};

  /// The coordinate of this direction itself.
  static Sloped coordinate(double value, int direction) {
    Sloped a;
    a.value = value;
    a.slope[direction / pack_width][direction % pack_width] = 1;
    return a;
  }
};

/// A number with f's value and the derivatives  da * a.slope + db * b.slope.
inline Sloped chain(double value, double da, const Sloped& a, double db, const Sloped& b) {
  Sloped out;
  out.value = value;
  for (int p = 0; p < slope_packs; ++p) out.slope[p] = da * a.slope[p] + db * b.slope[p];
  return out;
}

inline Sloped operator+(const Sloped& a, const Sloped& b) {
  return chain(a.value + b.value, 1, a, 1, b);
}
inline Sloped operator-(const Sloped& a, const Sloped& b) {
  return chain(a.value - b.value, 1, a, -1, b);
}
inline Sloped operator*(const Sloped& a, const Sloped& b) {
  return chain(a.value * b.value, b.value, a, a.value, b);
}
inline Sloped operator/(const Sloped& a, const Sloped& b) {
  const double over = 1 / b.value, quotient = a.value * over;
  return chain(quotient, over, a, -quotient * over, b);
}

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
