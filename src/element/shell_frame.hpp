// SPDX-License-Identifier: Apache-2.0
// The quadrilateral of a shell in its modes, and axes that follow it.
//
// A field on the corners is u = u_m + u_x xi + u_y eta + u_h xi eta, with xi = (-1, 1, 1, -1), eta = (-1, -1, 1, 1) at
// the corners. With a and b the first two modes of the positions, the normal at the centre is along a x b (which is
// that of the diagonals), and the first axis along r = a + b x normal, r . r = a.a + b.b + 2 |a x b|. In these axes the
// matrix with the columns a and b is symmetric: they are those of the polar decomposition of the map from the square.
// They therefore turn with the corners when these are counted from another one, by a right angle.
#pragma once
#include "core/simd.hpp"

namespace brunt::element {

/// Modes m, xi, eta and xi eta of a field on the corners.
BRUNT_INLINE void to_quad_modes(const Pack (&u)[4], Pack (&mode)[4]) {
  const Pack a = u[0] + u[2], b = u[1] + u[3], c = u[2] - u[0], d = u[1] - u[3];
  mode[0] = 0.25 * (a + b);
  mode[1] = 0.25 * (c + d);
  mode[2] = 0.25 * (c - d);
  mode[3] = 0.25 * (a - b);
}

/// Corner forces of mode forces: the transpose.
BRUNT_INLINE void from_quad_modes(const Pack (&mode)[4], Pack (&u)[4]) {
  const Pack a = mode[0] + mode[3], b = mode[0] - mode[3], c = mode[1] + mode[2], d = mode[1] - mode[2];
  u[0] = 0.25 * (a - c);
  u[1] = 0.25 * (b + d);
  u[2] = 0.25 * (a + c);
  u[3] = 0.25 * (b - d);
}

/// Row i is axis i.
struct ShellAxes {
  Pack e[3][3];

  BRUNT_INLINE void to_local(const Pack (&u)[3], Pack (&local)[3]) const {
    for (int i = 0; i < 3; ++i) local[i] = e[i][0] * u[0] + e[i][1] * u[1] + e[i][2] * u[2];
  }
  BRUNT_INLINE void to_global(const Pack (&u)[3], Pack (&global)[3]) const {
    for (int i = 0; i < 3; ++i) global[i] = e[0][i] * u[0] + e[1][i] * u[1] + e[2][i] * u[2];
  }
};

/// Two tangents a and b in axes of their own: [ax c; c by] and its inverse T = [by -c; -c ax] / J.
struct ShellTangents {
  ShellAxes axes;
  Pack ax, by, c, J;  ///< components [length]; J = |a x b|
  Pack over_J;
  Pack length;  ///< of r

  BRUNT_INLINE ShellTangents(const Pack (&a)[3], const Pack (&b)[3]) {
    Pack n[3], r[3];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = a[j] * b[k] - a[k] * b[j];
    }
    J = pack_sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const Pack aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    const Pack ab = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    length = pack_sqrt(aa + bb + 2.0 * J);
    const Pack both = 1.0 / (J * length), over = both * J;
    over_J = both * length;
    for (int i = 0; i < 3; ++i) axes.e[2][i] = over_J * n[i];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      r[i] = a[i] + (b[j] * axes.e[2][k] - b[k] * axes.e[2][j]);
    }
    for (int i = 0; i < 3; ++i) axes.e[0][i] = over * r[i];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      axes.e[1][i] = axes.e[2][j] * axes.e[0][k] - axes.e[2][k] * axes.e[0][j];
    }
    ax = over * (aa + J);
    by = over * (bb + J);
    c = over * ab;
  }

  /// (x, y) = T^T (xi, eta): derivatives by x and y from those by xi and eta.
  BRUNT_INLINE void gradient(Pack of_xi, Pack of_eta, Pack& x, Pack& y) const {
    x = over_J * (by * of_xi - c * of_eta);
    y = over_J * (ax * of_eta - c * of_xi);
  }
  /// Largest eigenvalue and trace of T T^T, the reciprocal metric [1/length^2].
  BRUNT_INLINE void metric(Pack& largest, Pack& trace) const {
    const Pack d = ax - by, sum = ax + by;
    const Pack root = 0.5 * (sum + pack_sqrt(d * d + 4.0 * c * c)) * over_J;
    largest = root * root;
    trace = (ax * ax + by * by + 2.0 * c * c) * over_J * over_J;
  }
};

}  // namespace brunt::element
