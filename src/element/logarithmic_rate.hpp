// SPDX-License-Identifier: Apache-2.0
// The step of a material point in the frame of the logarithmic rate.
//
// H. Xiao, O. T. Bruhns, A. Meyers, Acta Mechanica 124 (1997) 89-105: among all objective rates of corotational form
// only this one makes the stretching D the rate of a strain, h = ln V:
//   dh/dt - Omega h + h Omega = D,  Omega = W + N,  N_ij = -L(h_i - h_j) D_ij in the principal axes of h,
// with L(s) = coth s - 1/s (0 <= L(s)/s, L < 1). So h is integrated as the stress is, by rotation and strain increment,
// and an elastic law gives the stress of ln V, whatever the path.
//
// No principal axes are needed. With h' the deviator of h and a the axial vector of h D - D h, whose components in the
// principal axes are (h_i - h_j) D_ij, the axial vector of N is -l(M) a: M = 2 tr(h'^2) 1 - 3 h'^2 has the eigenvalues
// (h_i - h_j)^2 on the same axes, and l(s^2) = L(s)/s is the continued fraction 1/(3 + s^2/(5 + s^2/(7 + ...))), broken
// off after 11: relative error of l 1e-6 at s = 2, 4e-5 up to s = 3, 8e-4 up to s = 4.6 (a ratio of principal
// stretches of 100, simple shear of 10), never outside of 1/21 .. 1/3.
#pragma once
#include "element/objective.hpp"

namespace brunt::element {

/// Symmetric (xx, yy, zz, xy, yz, zx) times vector.
template <class Number>
BRUNT_INLINE void symmetric_times(const Number (&M)[6], const Number (&u)[3], Number (&result)[3]) {
  result[0] = M[0] * u[0] + M[3] * u[1] + M[5] * u[2];
  result[1] = M[3] * u[0] + M[1] * u[1] + M[4] * u[2];
  result[2] = M[5] * u[0] + M[4] * u[1] + M[2] * u[2];
}

/// M^2 of a symmetric M.
template <class Number>
BRUNT_INLINE void symmetric_square(const Number (&M)[6], Number (&square)[6]) {
  const Number xy = M[3] * M[3], yz = M[4] * M[4], zx = M[5] * M[5];
  square[0] = M[0] * M[0] + xy + zx;
  square[1] = M[1] * M[1] + xy + yz;
  square[2] = M[2] * M[2] + yz + zx;
  square[3] = (M[0] + M[1]) * M[3] + M[5] * M[4];
  square[4] = (M[1] + M[2]) * M[4] + M[3] * M[5];
  square[5] = (M[2] + M[0]) * M[5] + M[3] * M[4];
}

/// u <- P^-1 u for a symmetric positive P.
template <class Number>
BRUNT_INLINE void solve_symmetric(const Number (&P)[6], Number (&u)[3]) {
  const Number K[6] = {P[1] * P[2] - P[4] * P[4], P[2] * P[0] - P[5] * P[5], P[0] * P[1] - P[3] * P[3],
                       P[4] * P[5] - P[3] * P[2], P[5] * P[3] - P[4] * P[0], P[3] * P[4] - P[5] * P[1]};
  const Number over = 1.0 / (P[0] * K[0] + P[3] * K[3] + P[5] * K[5]);
  Number result[3];
  symmetric_times(K, u, result);
  for (int i = 0; i < 3; ++i) u[i] = over * result[i];
}

/// Axial vector of h d - d h for symmetric h and d.
template <class Number>
BRUNT_INLINE void commutator(const Number (&h)[6], const Number (&d)[6], Number (&axial)[3]) {
  axial[0] = (h[5] * d[3] - d[5] * h[3]) + (h[4] * (d[1] - d[2]) - d[4] * (h[1] - h[2]));
  axial[1] = (h[3] * d[4] - d[3] * h[4]) + (h[5] * (d[2] - d[0]) - d[5] * (h[2] - h[0]));
  axial[2] = (h[4] * d[5] - d[4] * h[5]) + (h[3] * (d[0] - d[1]) - d[3] * (h[0] - h[1]));
}

/// Axial vector of N times the step for the strain increment d at the logarithmic strain h.
template <class Number>
BRUNT_INLINE void logarithmic_spin(const Number (&h)[6], const Number (&d)[6], Number (&spin)[3]) {
  Number M[6], M2[6], P[6], deviator[6], a[3], Ma[3], MMa[3];
  const Number mean = (h[0] + h[1] + h[2]) * (1.0 / 3.0);
  for (int i = 0; i < 3; ++i) {
    deviator[i] = h[i] - mean;
    deviator[i + 3] = h[i + 3];
  }
  symmetric_square(deviator, M);
  const Number twice_trace = 2.0 * (M[0] + M[1] + M[2]);
  for (int i = 0; i < 3; ++i) {
    M[i] = twice_trace - 3.0 * M[i];
    M[i + 3] = -3.0 * M[i + 3];
  }
  // l = (3465 + 189 s^2 + s^4) / (10395 + 1260 s^2 + 21 s^4), the fifth convergent
  symmetric_square(M, M2);
  for (int i = 0; i < 3; ++i) {
    P[i] = 10395.0 + 1260.0 * M[i] + 21.0 * M2[i];
    P[i + 3] = 1260.0 * M[i + 3] + 21.0 * M2[i + 3];
  }
  commutator(h, d, a);
  symmetric_times(M, a, Ma);
  symmetric_times(M, Ma, MMa);
  for (int i = 0; i < 3; ++i) spin[i] = -(3465.0 * a[i] + 189.0 * Ma[i] + MMa[i]);
  solve_symmetric(P, spin);
}

/// Strain and rotation of a step, and h from its start (committed) to its end (trial). N is evaluated at the midpoint,
/// which depends on N itself: first from the start of the step, then from the resulting midpoint (second order in the
/// step).
template <class Number>
BRUNT_INLINE StrainStep<Number> logarithmic_step(const Number (&L)[9], double dt, const Pack* committed,
                                                 Number* trial) {
  Number d[6], w[3], spin[3], turn[3], h[6], middle[6];
  stretch_and_spin(L, dt, d, w);
  for (int c = 0; c < 6; ++c) h[c] = committed[c];
  logarithmic_spin(h, d, spin);
  for (int i = 0; i < 3; ++i) turn[i] = 0.5 * (w[i] + spin[i]);
  // h + d/2 + (Omega h - h Omega)/2
  const auto& [x, y, z] = turn;
  middle[0] = h[0] + 0.5 * d[0] + 2.0 * (y * h[5] - z * h[3]);
  middle[1] = h[1] + 0.5 * d[1] + 2.0 * (z * h[3] - x * h[4]);
  middle[2] = h[2] + 0.5 * d[2] + 2.0 * (x * h[4] - y * h[5]);
  middle[3] = h[3] + 0.5 * d[3] + (z * (h[0] - h[1]) + y * h[4] - x * h[5]);
  middle[4] = h[4] + 0.5 * d[4] + (x * (h[1] - h[2]) + z * h[5] - y * h[3]);
  middle[5] = h[5] + 0.5 * d[5] + (y * (h[2] - h[0]) + x * h[3] - z * h[4]);
  logarithmic_spin(middle, d, spin);
  for (int i = 0; i < 3; ++i) spin[i] += w[i];
  const StrainStep<Number> step = seen_from_end(d, spin);
  geometry::rotate_tensor(step.rotation, h);
  for (int c = 0; c < 6; ++c) trial[c] = h[c] + step.strain[c];
  return step;
}

/// By the objective rate of the law.
template <class Response, class Number>
BRUNT_INLINE StrainStep<Number> strain_step_of(const Number (&L)[9], double dt,
                                               const PointMemory<const Pack>& committed,
                                               const PointMemory<Number>& trial) {
  if constexpr (Response::logarithmic)
    return logarithmic_step(L, dt, committed.log_strain, trial.log_strain);
  else
    return strain_step(L, dt);
}

}  // namespace brunt::element
