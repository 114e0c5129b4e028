// SPDX-License-Identifier: Apache-2.0
// Signs of determinants of points, exact for the given coordinates: a filter by a bound of the rounding error, then
// sums without rounding (Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates,
// 1997).
#pragma once
#include <algorithm>
#include <array>

#include "geometry/triangles/triangle_pair.hpp"

namespace brunt::geometry {

/// Bound of the rounding error of a determinant of three differences, relative to the same sum with all terms positive:
/// three differences, two products, three sums along the longest path, each 2^-53, and the same amount for the bound
/// itself.
constexpr double determinant_rounding = 16 * 0x1p-53;

/// Sign of (b - a) x (c - a) . (d - a): positive if d is on the side from which a, b, c run counter-clockwise.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of the area of a, b, c projected along an axis: of the two other components in cyclic order.
int turn(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// Whether the closed segment and the closed triangle have a common point; exact, also for degenerate input.
bool segment_meets(const Vec3& from, const Vec3& to, const Triangle& triangle);

/// Whether the triangle has no area, exactly.
bool without_area(const Triangle& triangle);

/// The plane of a triangle, for sides of points.
struct SidePlane {
  Vec3 origin, normal, bound;  ///< bound: of the components of the normal with all terms positive

  explicit SidePlane(const Triangle& t) : origin(t[0]) {
    const Vec3 u = t[1] - t[0], v = t[2] - t[0];
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const double plus = u[i] * v[j], minus = u[j] * v[i];
      normal[k] = plus - minus;
      bound[k] = std::abs(plus) + std::abs(minus);
    }
  }

  /// 1 or -1 if the sign of the orientation is certain, otherwise 0.
  [[nodiscard]] int certain_side(const Vec3& p) const {
    const Vec3 d = p - origin;
    const double x = d[0] * normal[0], y = d[1] * normal[1], z = d[2] * normal[2];
    const double sum = x + y + z;
    const double limit =
        determinant_rounding * (std::abs(d[0]) * bound[0] + std::abs(d[1]) * bound[1] + std::abs(d[2]) * bound[2]);
    return static_cast<int>(sum > limit) - static_cast<int>(sum < -limit);
  }
};

}  // namespace brunt::geometry
