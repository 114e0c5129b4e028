// SPDX-License-Identifier: Apache-2.0
// Triangles with whole coordinates of up to 10^6: whether they cross and how far they are apart, decided with 128-bit
// integers; distances are quotients of two exact numbers, rounded once.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "geometry/triangles/triangle_pair.hpp"

namespace brunt::geometry::testing {

__extension__ using Int128 = __int128;
using IntVec = std::array<Int128, 3>;
using IntTriangle = std::array<IntVec, 3>;

inline IntVec operator-(const IntVec& a, const IntVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Int128 dot(const IntVec& a, const IntVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline IntVec cross(const IntVec& a, const IntVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline int sign(Int128 a) {
  return static_cast<int>(a > 0) - static_cast<int>(a < 0);
}
inline long double quotient(Int128 a, Int128 b) {
  return static_cast<long double>(a) / static_cast<long double>(b);
}

/// Squared distances.
inline long double from_segment(const IntVec& p, const IntVec& a, const IntVec& b) {
  const IntVec u = b - a, w = p - a;
  const Int128 along = dot(w, u), length2 = dot(u, u);
  if (along <= 0) return static_cast<long double>(dot(w, w));
  if (along >= length2) return static_cast<long double>(dot(p - b, p - b));
  const IntVec area = cross(w, u);
  return quotient(dot(area, area), length2);
}

inline long double from_triangle(const IntVec& p, const IntTriangle& t) {
  long double least = std::min({from_segment(p, t[0], t[1]), from_segment(p, t[1], t[2]), from_segment(p, t[2], t[0])});
  const IntVec n = cross(t[1] - t[0], t[2] - t[0]);
  bool inside = dot(n, n) > 0;
  for (std::size_t i = 0; i < 3; ++i) inside &= dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), n) >= 0;
  if (!inside) return least;
  const auto height = static_cast<long double>(dot(p - t[0], n));
  return std::min(least, height * height / static_cast<long double>(dot(n, n)));
}

/// Infinite where the common perpendicular meets not both.
inline long double between_edges(const IntVec& a, const IntVec& b, const IntVec& c, const IntVec& d) {
  const IntVec u = b - a, v = d - c, w = c - a, n = cross(u, v);
  const auto n2 = dot(n, n), s = dot(cross(w, v), n), t = dot(cross(w, u), n);
  if (n2 == 0 || s < 0 || s > n2 || t < 0 || t > n2) return std::numeric_limits<long double>::infinity();
  const auto height = static_cast<long double>(dot(w, n));
  return height * height / static_cast<long double>(n2);
}

/// Through the inside of a triangle with area, from one side to the other.
inline bool pierces(const IntVec& a, const IntVec& b, const IntTriangle& t) {
  const IntVec n = cross(t[1] - t[0], t[2] - t[0]);
  if (sign(dot(a - t[0], n)) * sign(dot(b - t[0], n)) >= 0) return false;
  int sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += sign(dot(b - a, cross(t[i] - a, t[(i + 1) % 3] - a)));
  return std::abs(sum) == 3;
}

/// Squared distance of the triangles, 0 exactly where they have a common point.
inline long double exact_distance2(const IntTriangle& a, const IntTriangle& b) {
  long double least = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    if (pierces(a[i], a[(i + 1) % 3], b) || pierces(b[i], b[(i + 1) % 3], a)) return 0;
    least = std::min({least, from_triangle(a[i], b), from_triangle(b[i], a)});
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, between_edges(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
  }
  return least;
}

inline Triangle as_doubles(const IntTriangle& t) {
  Triangle result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i][static_cast<int>(k)] = static_cast<double>(t[i][k]);
  return result;
}

}  // namespace brunt::geometry::testing
