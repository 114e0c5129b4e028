// SPDX-License-Identifier: Apache-2.0
// A bound of the largest frequency of the free 2x2x2 hexahedron that is exact for bricks.
//
// Split the velocity gradient at point p into its mean over the element and the rest, L_p = L + L'_p. The cross terms
// of the quadratic form sum_p V_p [lambda tr(L_p)^2 + 2 mu L_p : L_p] cancel, so it is Q + Q':
//   Q  <= alpha |u|^2,  alpha = [lambda tr S + 2 mu s_max(S)] / V,  S = B B^T  (the one-point element),
//   Q' <= beta |u|^2,   L'_p = sum_a q_a (x) w_ap with q_a = u_I gamma_aI and w_ap the hourglass gradients less their
//   mean, beta = (3 lambda + 2 mu) |H| |gamma gamma^T|, H_ab = sum_p V_p w_ap . w_bp (norms bounded by row sums).
// The largest eigenvalue of Q + Q' is that of the 2x2 matrix of the two norms and kappa, the norm of their product,
// kappa^2 <= (3 lambda + 2 mu)/V (beta / |gamma gamma^T|) |N|^2 with N_ak = gamma_aI B_kI (zero for parallelepipeds).
#pragma once
#include "element/batch.hpp"
#include "element/hex8_modes.hpp"
#include "element/hex8_point.hpp"

namespace brunt::element {

/// Sums over the Gauss points that the bound needs; a, b count the modes eta zeta, zeta xi, xi eta, xi eta zeta.
struct HourglassGram {
  Pack sum[10]{};  ///< of V_p grad h_a . grad h_b, for (a, b) = 00 01 02 03 11 12 13 22 23 33

  /// `K`: cofactors of dx/dxi at the point, `det` its determinant = V_p.
  void add(const HexPoint& p, const Pack (&K)[9], Pack det) {
    Pack gradient[4][3];  // times det
    for (int i = 0; i < 3; ++i) {
      const Pack &x = K[3 * i], &y = K[3 * i + 1], &z = K[3 * i + 2];
      gradient[0][i] = p.zeta * y + p.eta * z;
      gradient[1][i] = p.zeta * x + p.xi * z;
      gradient[2][i] = p.eta * x + p.xi * y;
      gradient[3][i] = (p.eta * p.zeta) * x + (p.zeta * p.xi) * y + (p.xi * p.eta) * z;
    }
    const Pack over = 1.0 / det;
    int pair = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = a; b < 4; ++b)
        sum[pair++] += over * (gradient[a][0] * gradient[b][0] + gradient[a][1] * gradient[b][1] +
                               gradient[a][2] * gradient[b][2]);
  }
};

/// Largest absolute row sum of a symmetric 4x4 matrix in the order of HourglassGram::sum.
BRUNT_INLINE Pack largest_row_sum(const Pack (&m)[10]) {
  constexpr int row[4][4] = {{0, 1, 2, 3}, {1, 4, 5, 6}, {2, 5, 7, 8}, {3, 6, 8, 9}};
  Pack largest = broadcast(0.0);
  for (const auto& entries : row)
    largest = pack_max(
        largest, pack_abs(m[entries[0]]) + pack_abs(m[entries[1]]) + pack_abs(m[entries[2]]) + pack_abs(m[entries[3]]));
  return largest;
}

/// Bound of the largest eigenvalue of the stiffness (force a length), corner masses apart. x: modes of the coordinates;
/// g, volume, S as above; lambda, mu: largest of all points; `point_modulus`: bounds
/// lambda tr(L')^2 + 2 mu L' : L' <= point_modulus L' : L', that is 3 lambda + 2 mu, or 2 mu where B-bar averages tr L.
/// `spring`: stiffness of springs on the hourglass modes that resist no less than Q' does.
BRUNT_INLINE Pack largest_stiffness(const Pack (&x)[hex_modes][3], const Pack (&g)[6][3], Pack volume,
                                    const Pack (&S)[6], const HourglassGram& gram, Pack lambda, Pack mu,
                                    Pack point_modulus, Pack& spring) {
  const Pack over_volume = 1.0 / volume;
  const Pack positive = pack_max(lambda, broadcast(0.0));
  const Pack alpha = over_volume * (positive * (S[0] + S[1] + S[2]) + 2.0 * mu * largest_eigenvalue_bound(S));

  // Sh = S h_a / V, so that gamma_a = Gamma_a - B h_a / V, N_a = Gamma_a B - Sh and Gamma_a B = 8 g_(3+a)
  Pack Sh[4][3], hg[4][3], N2 = broadcast(0.0);
  for (int a = 0; a < 4; ++a) {
    const auto& h = x[3 + a];
    for (int k = 0; k < 3; ++k) hg[a][k] = a < 3 ? 8.0 * g[3 + a][k] : broadcast(0.0);
    Sh[a][0] = over_volume * (S[0] * h[0] + S[3] * h[1] + S[5] * h[2]);
    Sh[a][1] = over_volume * (S[3] * h[0] + S[1] * h[1] + S[4] * h[2]);
    Sh[a][2] = over_volume * (S[5] * h[0] + S[4] * h[1] + S[2] * h[2]);
    for (int k = 0; k < 3; ++k) N2 += (hg[a][k] - Sh[a][k]) * (hg[a][k] - Sh[a][k]);
  }
  Pack gamma_gram[10], H[10];
  int pair = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = a; b < 4; ++b, ++pair) {
      Pack product = broadcast(a == b ? 8.0 : 0.0), mean = broadcast(0.0);
      for (int k = 0; k < 3; ++k) {
        product -= over_volume * (x[3 + a][k] * (hg[b][k] - Sh[b][k]) + x[3 + b][k] * hg[a][k]);
        mean += hg[a][k] * hg[b][k];
      }
      gamma_gram[pair] = product;
      H[pair] = (1.0 / 64.0) * (gram.sum[pair] - over_volume * mean);
    }
  const Pack rest = point_modulus * largest_row_sum(H);
  spring = rest;
  const Pack beta = rest * largest_row_sum(gamma_gram);
  const Pack kappa2 = pack_min(alpha * beta, (3.0 * positive + 2.0 * mu) * over_volume * rest * N2);
  const Pack half = 0.5 * (alpha - beta);
  return 0.5 * (alpha + beta) + pack_sqrt(half * half + kappa2);
}

}  // namespace brunt::element
