// SPDX-License-Identifier: Apache-2.0
// Vectors of any number type: a number, or a pack for each component. Sums have a fixed order, so that a pair gives the
// same bits alone and in a lane.
#pragma once
#include <cmath>

#include "core/simd.hpp"
#include "core/types.hpp"

namespace brunt::geometry {

template <class T>
struct VecOf {
  T x, y, z;
};

template <class T>
BRUNT_INLINE VecOf<T> operator+(const VecOf<T>& a, const VecOf<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
BRUNT_INLINE VecOf<T> operator-(const VecOf<T>& a, const VecOf<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
BRUNT_INLINE VecOf<T> operator*(T s, const VecOf<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
BRUNT_INLINE T dot(const VecOf<T>& a, const VecOf<T>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template <class T>
BRUNT_INLINE VecOf<T> cross(const VecOf<T>& a, const VecOf<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

BRUNT_INLINE double root(double a) {
  return std::sqrt(a);
}
BRUNT_INLINE Pack root(Pack a) {
  return pack_sqrt(a);
}
template <class T>
BRUNT_INLINE T norm(const VecOf<T>& a) {
  return root(dot(a, a));
}

BRUNT_INLINE VecOf<double> vec_of(const Vec3& a) {
  return {a[0], a[1], a[2]};
}

/// A vector for each lane.
using PackVec = VecOf<Pack>;

}  // namespace brunt::geometry
