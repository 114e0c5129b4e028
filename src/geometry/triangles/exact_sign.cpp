// SPDX-License-Identifier: Apache-2.0
#include "exact_sign.hpp"

#include <cmath>
#include <cstddef>

namespace brunt::geometry {
namespace {

/// A sum of doubles without overlapping bits, in ascending order of magnitude, without zeros: exact.
template <std::size_t capacity>
struct Expansion {
  std::array<double, capacity> term;
  std::size_t count = 0;
  void append(double value) {
    if (value != 0) term[count++] = value;
  }
};

/// sum + error = a + b
struct TwoSum {
  double sum, error;
  TwoSum(double a, double b) : sum(a + b) {
    const double b_part = sum - a, a_part = sum - b_part;
    error = (a - a_part) + (b - b_part);
  }
};

Expansion<2> difference(double a, double b) {
  Expansion<2> result;
  const TwoSum s(a, -b);
  result.append(s.error);
  result.append(s.sum);
  return result;
}

template <std::size_t n, std::size_t m>
Expansion<n + m> operator+(const Expansion<n>& e, const Expansion<m>& f) {
  std::array<double, n + m> merged;
  const auto end = std::merge(e.term.begin(), e.term.begin() + e.count, f.term.begin(), f.term.begin() + f.count,
                              merged.begin(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  Expansion<n + m> result;
  double carried = 0;
  for (auto term = merged.begin(); term != end; ++term) {
    const TwoSum s(carried, *term);
    result.append(s.error);
    carried = s.sum;
  }
  result.append(carried);
  return result;
}

template <std::size_t n>
Expansion<2 * n> operator*(const Expansion<n>& e, double b) {
  Expansion<2 * n> result;
  double carried = 0;
  for (std::size_t i = 0; i < e.count; ++i) {
    const double product = e.term[i] * b, product_error = std::fma(e.term[i], b, -product);
    const TwoSum low(carried, product_error);
    result.append(low.error);
    const TwoSum high(product, low.sum);
    result.append(high.error);
    carried = high.sum;
  }
  result.append(carried);
  return result;
}

template <std::size_t n>
Expansion<4 * n> operator*(const Expansion<n>& e, const Expansion<2>& f) {
  const double first = f.count > 0 ? f.term[0] : 0.0, second = f.count > 1 ? f.term[1] : 0.0;
  return e * first + e * second;
}

template <std::size_t n>
Expansion<n> operator-(const Expansion<n>& e) {
  Expansion<n> result = e;
  for (std::size_t i = 0; i < e.count; ++i) result.term[i] = -e.term[i];
  return result;
}

template <std::size_t n>
int sign(const Expansion<n>& e) {
  return e.count == 0 ? 0 : (e.term[e.count - 1] > 0 ? 1 : -1);
}

using Difference = std::array<Expansion<2>, 3>;

Difference difference(const Vec3& a, const Vec3& b) {
  return {difference(a[0], b[0]), difference(a[1], b[1]), difference(a[2], b[2])};
}

/// u_i v_j - u_j v_i
Expansion<16> minor_of(const Difference& u, const Difference& v, std::size_t i, std::size_t j) {
  return u[i] * v[j] + -(u[j] * v[i]);
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Difference u = difference(b, a), v = difference(c, a), w = difference(d, a);
  return sign((minor_of(u, v, 1, 2) * w[0] + minor_of(u, v, 2, 0) * w[1]) + minor_of(u, v, 0, 1) * w[2]);
}

/// Whether closed segments in one plane intersect in the projection along an axis; one or both may be points.
bool segments_meet_along(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int axis) {
  const int on_c = turn(a, b, c, axis), on_d = turn(a, b, d, axis);
  const int on_a = turn(c, d, a, axis), on_b = turn(c, d, b, axis);
  if (on_c * on_d > 0 || on_a * on_b > 0) return false;
  for (int k = 0; k < 3; ++k) {  // for collinear segments the boxes decide
    if (k == axis) continue;
    const auto [a_low, a_high] = std::minmax(a[k], b[k]);
    const auto [c_low, c_high] = std::minmax(c[k], d[k]);
    if (a_high < c_low || c_high < a_low) return false;
  }
  return true;
}

/// If all four points are coplanar, the segments intersect if their projections along every axis do: in at least one of
/// them the projection of the plane is not degenerate.
bool segments_meet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  for (int axis = 0; axis < 3; ++axis)
    if (!segments_meet_along(a, b, c, d, axis)) return false;
  return orientation(a, b, c, d) == 0;
}

/// For a point in the plane of the triangle.
bool point_within(const Vec3& p, const Triangle& t) {
  bool seen = false;
  for (int axis = 0; axis < 3; ++axis) {
    const int whole = turn(t[0], t[1], t[2], axis);
    if (whole == 0) continue;
    seen = true;
    for (std::size_t i = 0; i < 3; ++i)
      if (turn(t[i], t[(i + 1) % 3], p, axis) * whole < 0) return false;
  }
  return seen;
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const int certain = SidePlane({a, b, c}).certain_side(d);
  return certain != 0 ? certain : exact_orientation(a, b, c, d);
}

int turn(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double plus = (b[i] - a[i]) * (c[j] - a[j]), minus = (b[j] - a[j]) * (c[i] - a[i]);
  const double area = plus - minus, limit = determinant_rounding * (std::abs(plus) + std::abs(minus));
  if (area > limit) return 1;
  if (area < -limit) return -1;
  const auto x = static_cast<std::size_t>(i), y = static_cast<std::size_t>(j);
  return sign(minor_of(difference(b, a), difference(c, a), x, y));
}

bool without_area(const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis)
    if (turn(t[0], t[1], t[2], axis) != 0) return false;
  return true;
}

bool segment_meets(const Vec3& from, const Vec3& to, const Triangle& t) {
  const int side_from = orientation(t[0], t[1], t[2], from), side_to = orientation(t[0], t[1], t[2], to);
  if (side_from * side_to > 0) return false;
  if (side_from == 0 && side_to == 0) {
    for (std::size_t i = 0; i < 3; ++i)
      if (segments_meet(from, to, t[i], t[(i + 1) % 3])) return true;
    return point_within(from, t);
  }
  int least = 1, greatest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = orientation(from, to, t[i], t[(i + 1) % 3]);
    least = std::min(least, side);
    greatest = std::max(greatest, side);
  }
  return least >= 0 || greatest <= 0;
}

}  // namespace brunt::geometry
