// SPDX-License-Identifier: Apache-2.0
// Dual numbers: forward differentiation of code that is written for packs.
#pragma once
#include "core/simd.hpp"

namespace brunt {

/// A value and its derivative in one direction, in each lane. Code written for a Pack and called with duals computes
/// the same values (up to the rounding of products that a compiler fuses) and their exact derivatives along the
/// branches taken.
struct Dual {
  Pack value, slope;

  Dual() = default;
  Dual(Pack constant) : value(constant), slope{} {}
  Dual(double constant) : value(broadcast(constant)), slope{} {}
  Dual(Pack value_, Pack slope_) : value(value_), slope(slope_) {}

  BRUNT_INLINE Dual& operator+=(const Dual& b);
  BRUNT_INLINE Dual& operator-=(const Dual& b);
  BRUNT_INLINE Dual& operator*=(const Dual& b);
  BRUNT_INLINE Dual& operator/=(const Dual& b);
};

BRUNT_INLINE Dual operator-(const Dual& a) {
  return {-a.value, -a.slope};
}
BRUNT_INLINE Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.slope + b.slope};
}
BRUNT_INLINE Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.slope - b.slope};
}
BRUNT_INLINE Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}
BRUNT_INLINE Dual operator/(const Dual& a, const Dual& b) {
  const Pack over = 1.0 / b.value, quotient = a.value * over;
  return {quotient, over * (a.slope - quotient * b.slope)};
}

// Operations with constants, whose derivative is zero.
BRUNT_INLINE Dual operator+(const Dual& a, Pack b) {
  return {a.value + b, a.slope};
}
BRUNT_INLINE Dual operator+(Pack a, const Dual& b) {
  return {a + b.value, b.slope};
}
BRUNT_INLINE Dual operator-(const Dual& a, Pack b) {
  return {a.value - b, a.slope};
}
BRUNT_INLINE Dual operator-(Pack a, const Dual& b) {
  return {a - b.value, -b.slope};
}
BRUNT_INLINE Dual operator*(const Dual& a, Pack b) {
  return {a.value * b, a.slope * b};
}
BRUNT_INLINE Dual operator*(Pack a, const Dual& b) {
  return {a * b.value, a * b.slope};
}
BRUNT_INLINE Dual operator+(const Dual& a, double b) {
  return a + broadcast(b);
}
BRUNT_INLINE Dual operator+(double a, const Dual& b) {
  return broadcast(a) + b;
}
BRUNT_INLINE Dual operator-(const Dual& a, double b) {
  return a - broadcast(b);
}
BRUNT_INLINE Dual operator-(double a, const Dual& b) {
  return broadcast(a) - b;
}
BRUNT_INLINE Dual operator*(const Dual& a, double b) {
  return a * broadcast(b);
}
BRUNT_INLINE Dual operator*(double a, const Dual& b) {
  return broadcast(a) * b;
}
BRUNT_INLINE Dual operator/(const Dual& a, Pack b) {
  return {a.value / b, a.slope / b};
}
BRUNT_INLINE Dual operator/(double a, const Dual& b) {
  const Pack quotient = a / b.value;
  return {quotient, -quotient * b.slope / b.value};
}

BRUNT_INLINE Dual& Dual::operator+=(const Dual& b) {
  return *this = *this + b;
}
BRUNT_INLINE Dual& Dual::operator-=(const Dual& b) {
  return *this = *this - b;
}
BRUNT_INLINE Dual& Dual::operator*=(const Dual& b) {
  return *this = *this * b;
}
BRUNT_INLINE Dual& Dual::operator/=(const Dual& b) {
  return *this = *this / b;
}

BRUNT_INLINE PackMask operator>(const Dual& a, const Dual& b) {
  return a.value > b.value;
}
BRUNT_INLINE PackMask operator<(const Dual& a, const Dual& b) {
  return a.value < b.value;
}
BRUNT_INLINE Dual select(PackMask mask, const Dual& yes, const Dual& no) {
  return {select(mask, yes.value, no.value), select(mask, yes.slope, no.slope)};
}
BRUNT_INLINE Dual pack_max(const Dual& a, const Dual& b) {
  return select(a > b, a, b);
}
BRUNT_INLINE Dual pack_min(const Dual& a, const Dual& b) {
  return select(a < b, a, b);
}

/// The derivative at zero is defined as zero: the roots used here are of sums of squares, which have their minimum
/// there.
BRUNT_INLINE Dual pack_sqrt(const Dual& a) {
  const Pack root = pack_sqrt(a.value);
  return {root, select(root > 0.0, 0.5 * a.slope / root, Pack{})};
}

}  // namespace brunt
