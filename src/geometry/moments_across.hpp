// SPDX-License-Identifier: Apache-2.0
// Second moments of points across a normal.
#pragma once
#include <algorithm>

#include "core/types.hpp"

namespace brunt::geometry {

/// The part of a symmetric matrix of second moments [length^2] that lies across a unit normal.
struct MomentsAcross {
  Vec3 first, second;
  double a, b, c;  ///< along first, mixed, along second [length^2]

  MomentsAcross(const Mat3& moments, const Vec3& normal)
      : first(normal.unitOrthogonal()),
        second(normal.cross(first)),
        a(first.dot(moments * first)),
        b(first.dot(moments * second)),
        c(second.dot(moments * second)) {}
  /// The points do not lie on a line.
  [[nodiscard]] bool are_plane() const {
    constexpr double flat = 1e-6;
    const double most = std::max(a, c);
    return a * c - b * b > flat * most * most;
  }
  /// Of the points across the normal: maps the normal to zero [1/length^2].
  [[nodiscard]] Mat3 inverse() const {
    const double det = a * c - b * b;
    const Vec3 of_first = (c * first - b * second) / det, of_second = (a * second - b * first) / det;
    return of_first * first.transpose() + of_second * second.transpose();
  }
  /// The vector across the normal that the moments map to that part of `image`.
  [[nodiscard]] Vec3 solve(const Vec3& image) const {
    const double x = first.dot(image), y = second.dot(image), det = a * c - b * b;
    return (c * x - b * y) / det * first + (a * y - b * x) / det * second;
  }
};

}  // namespace brunt::geometry
