// SPDX-License-Identifier: Apache-2.0
// The trilinear hexahedron in the basis of its eight nodal modes, where the one-point element is cheapest.
//
// The nodal values u_I of any field are combinations of 1, xi, eta, zeta (linear) and eta zeta, zeta xi, xi eta,
// xi eta zeta (hourglass), each +-1 at the nodes; the modes are orthogonal with norm 8. Write a_1, a_2, a_3 for the
// sums of x_I with the linear and h_1 .. h_4 with the hourglass modes. Then the volume is exactly
//   64 V = det(a1,a2,a3) + 1/3 [ det(a1,h3,h2) + det(h2,h1,a3) + det(h3,a2,h1) ],
// and the mean gradient of the shape functions times V, B_iI = dV/dx_iI (D. P. Flanagan, T. Belytschko, Int. J. Numer.
// Meth. Eng. 17 (1981) 679, eq (21)), has in this basis the six vectors g_m = dV/d(mode m); that of h4 is zero.
#pragma once
#include "core/simd.hpp"

namespace brunt::element {

/// Modes in the order xi, eta, zeta, eta zeta, zeta xi, xi eta, xi eta zeta (the constant one is never needed).
constexpr int hex_modes = 7;

/// Sums of nodal values with each mode; nodes in the order of core/cells.hpp.
template <class Number>
BRUNT_INLINE void to_modes(const Number (&u)[8], Number (&mode)[hex_modes]) {
  const auto plane = [](Number y0, Number y1, Number y2, Number y3, Number& xi, Number& eta, Number& xi_eta) {
    const Number lower = y1 - y0, upper = y2 - y3;
    xi = lower + upper;
    xi_eta = upper - lower;
    eta = (y2 + y3) - (y0 + y1);
  };
  Number sum[4], difference[4];
  for (int k = 0; k < 4; ++k) {
    sum[k] = u[k + 4] + u[k];
    difference[k] = u[k + 4] - u[k];
  }
  plane(sum[0], sum[1], sum[2], sum[3], mode[0], mode[1], mode[5]);
  plane(difference[0], difference[1], difference[2], difference[3], mode[4], mode[3], mode[6]);
  mode[2] = (difference[0] + difference[1]) + (difference[2] + difference[3]);
}

/// Nodal values of a combination of modes (no constant part): the transpose of to_modes.
template <class Number>
BRUNT_INLINE void from_modes(const Number (&mode)[hex_modes], Number (&u)[8]) {
  const auto plane = [](Number constant, Number xi, Number eta, Number xi_eta, Number(&y)[4]) {
    const Number minus = xi - xi_eta, plus = xi + xi_eta;
    const Number low = constant - eta, high = constant + eta;
    y[0] = low - minus;
    y[1] = low + minus;
    y[2] = high + plus;
    y[3] = high - plus;
  };
  Number even[4], odd[4];
  plane(broadcast(0.0), mode[0], mode[1], mode[5], even);
  plane(mode[2], mode[4], mode[3], mode[6], odd);
  for (int k = 0; k < 4; ++k) {
    u[k] = even[k] - odd[k];
    u[k + 4] = even[k] + odd[k];
  }
}

/// out = scale (a x b + third (c x d)) for vectors stored as component arrays [3]
template <class Number>
BRUNT_INLINE void cross_pair(const Number (&a)[3], const Number (&b)[3], const Number (&c)[3], const Number (&d)[3],
                             double first, double second, Number (&out)[3]) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = first * (a[j] * b[k] - a[k] * b[j]) + second * (c[j] * d[k] - c[k] * d[j]);
  }
}

/// Gradient modes g_m (m = 0..5) and volume of the element whose coordinates have the modes x[m][component].
template <class Number>
BRUNT_INLINE Number gradient_modes(const Number (&x)[hex_modes][3], Number (&g)[6][3]) {
  constexpr double one = 1.0 / 64.0, third = 1.0 / 192.0;
  const auto &a1 = x[0], &a2 = x[1], &a3 = x[2], &h1 = x[3], &h2 = x[4], &h3 = x[5];
  cross_pair(a2, a3, h3, h2, one, third, g[0]);
  cross_pair(a3, a1, h1, h3, one, third, g[1]);
  cross_pair(a1, a2, h2, h1, one, third, g[2]);
  cross_pair(a3, h2, h3, a2, third, third, g[3]);
  cross_pair(a1, h3, h1, a3, third, third, g[4]);
  cross_pair(h2, a1, a2, h1, third, third, g[5]);
  return a1[0] * g[0][0] + a1[1] * g[0][1] + a1[2] * g[0][2] + (h1[0] * g[3][0] + h1[1] * g[3][1] + h1[2] * g[3][2]);
}

/// S = B B^T (xx, yy, zz, xy, yz, zx) from the gradient modes.
template <class Number>
BRUNT_INLINE void gradient_gram(const Number (&g)[6][3], Number (&S)[6]) {
  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  for (int c = 0; c < 6; ++c) {
    Number sum = g[0][row[c]] * g[0][column[c]];
    for (int m = 1; m < 6; ++m) sum += g[m][row[c]] * g[m][column[c]];
    S[c] = 8.0 * sum;
  }
}

}  // namespace brunt::element
