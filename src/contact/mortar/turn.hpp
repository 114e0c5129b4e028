// SPDX-License-Identifier: Apache-2.0
// The smallest rotation from one unit vector to another.
#pragma once
#include "core/types.hpp"

namespace brunt::contact {

/// If 1 + from . to is smaller, the vectors are opposite, and the smallest rotation is not unique.
constexpr double opposite = 1e-8;

/// R v = v - ((from + to) . v)/(1 + from . to) (from + to) + 2 (from . v) to; v itself if they are opposite.
inline Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to) {
  const double c = 1 + from.dot(to);
  if (c < opposite) return v;
  return v - (from + to).dot(v) / c * (from + to) + 2 * from.dot(v) * to;
}

/// Its derivative by `to`.
inline Mat3 turned_slope(const Vec3& v, const Vec3& from, const Vec3& to) {
  const double c = 1 + from.dot(to), q = (from + to).dot(v);
  if (c < opposite) return Mat3::Zero();
  return (from + to) * (q / (c * c) * from - v / c).transpose() + (2 * from.dot(v) - q / c) * Mat3::Identity();
}

}  // namespace brunt::contact
