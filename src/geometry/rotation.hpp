// SPDX-License-Identifier: Apache-2.0
// Finite rotation from a spin increment, and its application to vectors and symmetric tensors, one pack at a time. T.
// J. R. Hughes, J. Winget, Int. J. Numer. Meth. Eng. 15 (1980) 1862: with the velocity gradient in the midpoint
// configuration, the rotation of a rigid motion is exact.
#pragma once
#include "core/simd.hpp"

namespace brunt::geometry {

/// R = (I - W/2)^-1 (I + W/2) for the skew W with axial vector w (W u = w x u), row major; orthogonal for any w.
template <class Number>
BRUNT_INLINE void rotation_of_spin(const Number (&w)[3], Number (&R)[9]) {
  const Number xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
  const Number a = 1.0 / (1.0 + 0.25 * (xx + yy + zz));  // R = I + a (W + W^2/2)
  const Number h = 0.5 * a;
  const Number xy = h * w[0] * w[1], yz = h * w[1] * w[2], zx = h * w[2] * w[0];
  R[0] = 1.0 - h * (yy + zz);
  R[4] = 1.0 - h * (zz + xx);
  R[8] = 1.0 - h * (xx + yy);
  R[1] = xy - a * w[2];
  R[3] = xy + a * w[2];
  R[5] = yz - a * w[0];
  R[7] = yz + a * w[0];
  R[6] = zx - a * w[1];
  R[2] = zx + a * w[1];
}

/// u <- R u
template <class Number>
BRUNT_INLINE void rotate_vector(const Number (&R)[9], Number& x, Number& y, Number& z) {
  const Number a = R[0] * x + R[1] * y + R[2] * z;
  const Number b = R[3] * x + R[4] * y + R[5] * z;
  z = R[6] * x + R[7] * y + R[8] * z;
  x = a;
  y = b;
}

/// s <- R s R^T for s = (xx, yy, zz, xy, yz, zx)
template <class Number>
BRUNT_INLINE void rotate_tensor(const Number (&R)[9], Number* s) {
  Number t[9];  // R s
  for (int i = 0; i < 3; ++i) {
    const Number &p = R[3 * i], &q = R[3 * i + 1], &r = R[3 * i + 2];
    t[3 * i] = p * s[0] + q * s[3] + r * s[5];
    t[3 * i + 1] = p * s[3] + q * s[1] + r * s[4];
    t[3 * i + 2] = p * s[5] + q * s[4] + r * s[2];
  }
  s[0] = t[0] * R[0] + t[1] * R[1] + t[2] * R[2];
  s[1] = t[3] * R[3] + t[4] * R[4] + t[5] * R[5];
  s[2] = t[6] * R[6] + t[7] * R[7] + t[8] * R[8];
  s[3] = t[0] * R[3] + t[1] * R[4] + t[2] * R[5];
  s[4] = t[3] * R[6] + t[4] * R[7] + t[5] * R[8];
  s[5] = t[6] * R[0] + t[7] * R[1] + t[8] * R[2];
}

}  // namespace brunt::geometry
