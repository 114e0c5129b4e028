// SPDX-License-Identifier: Apache-2.0
// One of the 2x2x2 Gauss points of the trilinear hexahedron, in the basis of its nodal modes (hex8_modes.hpp): there
// the parent gradient of a field costs four terms a direction, and no shape functions are needed.
#pragma once
#include "core/simd.hpp"
#include "element/hex8_modes.hpp"

namespace brunt::element {

constexpr int hex_points = 8;

/// Parent coordinates of Gauss point p, all weights 1; points in the order of the nodes' xi fastest, zeta slowest.
struct HexPoint {
  double xi, eta, zeta;
  explicit constexpr HexPoint(int p) : xi(p & 1 ? at : -at), eta(p & 2 ? at : -at), zeta(p & 4 ? at : -at) {}
  static constexpr double at = 0.57735026918962576451;  ///< 1/sqrt(3)
};

/// G_ij = du_i/dxi_j (row major) of the field with modes u[m][component].
template <class Number>
BRUNT_INLINE void parent_gradient(const HexPoint& p, const Number (&u)[hex_modes][3], Number (&G)[9]) {
  for (int i = 0; i < 3; ++i) {
    G[3 * i] = 0.125 * (u[0][i] + p.zeta * u[4][i] + p.eta * u[5][i] + p.eta * p.zeta * u[6][i]);
    G[3 * i + 1] = 0.125 * (u[1][i] + p.zeta * u[3][i] + p.xi * u[5][i] + p.zeta * p.xi * u[6][i]);
    G[3 * i + 2] = 0.125 * (u[2][i] + p.eta * u[3][i] + p.xi * u[4][i] + p.xi * p.eta * u[6][i]);
  }
}

/// force[i][m] -= A_ij d(mode m)/dxi_j / 8, the transpose of parent_gradient.
template <class Number>
BRUNT_INLINE void subtract_parent_force(const HexPoint& p, const Number (&A)[9], Number (&force)[3][hex_modes]) {
  for (int i = 0; i < 3; ++i) {
    const Number x = 0.125 * A[3 * i], y = 0.125 * A[3 * i + 1], z = 0.125 * A[3 * i + 2];
    force[i][0] -= x;
    force[i][1] -= y;
    force[i][2] -= z;
    force[i][3] -= p.zeta * y + p.eta * z;
    force[i][4] -= p.zeta * x + p.xi * z;
    force[i][5] -= p.eta * x + p.xi * y;
    force[i][6] -= (p.eta * p.zeta) * x + (p.zeta * p.xi) * y + (p.xi * p.eta) * z;
  }
}

/// Cofactors K of J (K = det J times the inverse transposed) and the determinant.
template <class Number>
BRUNT_INLINE Number cofactors(const Number (&J)[9], Number (&K)[9]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      K[3 * i + j] = J[3 * i1 + j1] * J[3 * i2 + j2] - J[3 * i1 + j2] * J[3 * i2 + j1];
    }
  return J[0] * K[0] + J[1] * K[1] + J[2] * K[2];
}

/// Gradient du_i/dx_j in space from parent gradients: (du/dxi) (dx/dxi)^-1. Returns det(dx/dxi).
template <class Number, class Shape>
BRUNT_INLINE Shape space_gradient(const Number (&u_parent)[9], const Shape (&x_parent)[9], Number (&L)[9]) {
  Shape K[9];
  const Shape det = cofactors(x_parent, K);
  const Shape over = 1.0 / det;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      L[3 * i + j] =
          over * (u_parent[3 * i] * K[3 * j] + u_parent[3 * i + 1] * K[3 * j + 1] + u_parent[3 * i + 2] * K[3 * j + 2]);
  return det;
}

/// A = s K for a symmetric s = (xx, yy, zz, xy, yz, zx): the force of a stress on the parent directions.
template <class Number>
BRUNT_INLINE void stress_times_cofactors(const Number (&s)[6], const Number (&K)[9], Number (&A)[9]) {
  const Number full[9] = {s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      A[3 * i + j] = full[3 * i] * K[j] + full[3 * i + 1] * K[3 + j] + full[3 * i + 2] * K[6 + j];
}

}  // namespace brunt::element
