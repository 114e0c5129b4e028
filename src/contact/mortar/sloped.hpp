// SPDX-License-Identifier: Apache-2.0
// A number and its derivatives by the sixteen coordinates of two facets in a plane.
#pragma once
#include "core/simd.hpp"

namespace brunt::contact {

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

}  // namespace brunt::contact
