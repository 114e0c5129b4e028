// SPDX-License-Identifier: Apache-2.0
// Strains of the quadrilateral of a shell with 2 x 2 points, and their transpose, the forces.
//
// K. J. Bathe, E. N. Dvorkin, Int. J. Numer. Meth. Eng. 21 (1985) 367: a point at the height z over corner I moves with
// v_I + z p_I, p_I = r_I x d_I, the director d_I the unit normal of the bilinear surface at the corner. With a comma
// for derivatives by xi and eta, in three dimensions and to the first order in z:
//   membrane  (x,a . v,b + x,b . v,a)/2,   curvature  (x,a . p,b + d,a . v,b + the same with a and b exchanged)/2
//   shears    v,a . d + x,a . p at the middles of the edges, linear between opposite ones
// brought into axes of the tangent plane of each point. All vanish in rigid motions of any shape.
#pragma once
#include "core/simd.hpp"
#include "element/shell_frame.hpp"

namespace brunt::element {

/// Modes of positions and directors in space, [mode][component].
struct Shell4FullShape {
  Pack x[4][3], d[4][3];
  Pack director[3][4];  ///< at the corners
  Pack least;           ///< smallest Jacobian of the corners over that of the centre; not positive where one is folded
};

/// What one point of the rule sees.
struct Shell4Point {
  double xi, eta;  ///< weight 1
  Pack a[3], b[3], da[3], db[3];
  ShellTangents plane;

  BRUNT_INLINE Shell4Point(const Shell4FullShape& shape, int p)
      : xi(p == 1 || p == 2 ? at : -at), eta(p > 1 ? at : -at), plane(set(shape)) {}

  /// T C T of a symmetric tensor xx, yy, xy: from covariant components to those of the axes, or from these to
  /// contravariant ones.
  BRUNT_INLINE void transform(const Pack (&c)[3], Pack (&e)[3]) const {
    const Pack x = plane.over_J * plane.by, y = plane.over_J * plane.ax, m = -plane.over_J * plane.c;
    const Pack px = x * c[0] + m * c[2], py = x * c[2] + m * c[1];  // T C
    const Pack qx = m * c[0] + y * c[2], qy = m * c[2] + y * c[1];
    e[0] = px * x + py * m;
    e[1] = qx * m + qy * y;
    e[2] = px * m + py * y;
  }

  static constexpr double at = 0.57735026918962576451;  ///< 1/sqrt(3)

 private:
  BRUNT_INLINE ShellTangents set(const Shell4FullShape& shape) {
    for (int i = 0; i < 3; ++i) {
      a[i] = shape.x[1][i] + eta * shape.x[3][i];
      b[i] = shape.x[2][i] + xi * shape.x[3][i];
      da[i] = shape.d[1][i] + eta * shape.d[3][i];
      db[i] = shape.d[2][i] + xi * shape.d[3][i];
    }
    return {a, b};
  }
};

namespace shell4_full_detail {

BRUNT_INLINE Pack dot(const Pack (&a)[3], const Pack (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

BRUNT_INLINE void modes_of(const Pack (&u)[3][4], Pack (&mode)[4][3]) {
  for (int i = 0; i < 3; ++i) {
    Pack of_component[4];
    to_quad_modes(u[i], of_component);
    for (int m = 0; m < 4; ++m) mode[m][i] = of_component[m];
  }
}

BRUNT_INLINE void shape_of(const Pack (&x)[3][4], Shell4FullShape& shape) {
  modes_of(x, shape.x);
  const auto &a = shape.x[1], &b = shape.x[2];
  Pack centre[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    centre[i] = a[j] * b[k] - a[k] * b[j];
  }
  const Pack over = 1.0 / dot(centre, centre);
  for (int c = 0; c < 4; ++c) {
    const int before = (c + 3) % 4, after = (c + 1) % 4;
    Pack n[3];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = (x[j][c] - x[j][before]) * (x[k][after] - x[k][c]) - (x[k][c] - x[k][before]) * (x[j][after] - x[j][c]);
    }
    const Pack share = (0.25 * over) * dot(n, centre);
    shape.least = c == 0 ? share : pack_min(shape.least, share);
    const Pack norm = 1.0 / pack_sqrt(dot(n, n));
    for (int i = 0; i < 3; ++i) shape.director[i][c] = norm * n[i];
  }
  modes_of(shape.director, shape.d);
}

/// Modes of r x d at the corners, or of its transpose d x f with sign -1.
BRUNT_INLINE void cross_directors(const Shell4FullShape& shape, double sign, const Pack (&r)[3][4], Pack (&p)[3][4]) {
  const auto& d = shape.director;
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      p[i][c] = sign * (r[j][c] * d[k][c] - r[k][c] * d[j][c]);
    }
}

/// Shears along the edges: mean and difference of those along xi, then along eta. v, p: modes [mode][component].
struct EdgeShears {
  Pack mean[2], linear[2];
};
BRUNT_INLINE EdgeShears edge_shears(const Shell4FullShape& shape, const Pack (&v)[4][3], const Pack (&p)[4][3]) {
  const auto &x = shape.x, &d = shape.d;
  EdgeShears shears;
  for (int s = 0; s < 2; ++s) {
    const int along = 1 + s, across = 2 - s;
    shears.mean[s] = dot(v[along], d[0]) + dot(v[3], d[across]) + dot(x[along], p[0]) + dot(x[3], p[across]);
    shears.linear[s] = dot(v[3], d[0]) + dot(v[along], d[across]) + dot(x[along], p[across]) + dot(x[3], p[0]);
  }
  return shears;
}

/// The transpose, added to forces on the modes.
BRUNT_INLINE void add_edge_forces(const Shell4FullShape& shape, const EdgeShears& force, Pack (&f)[4][3],
                                  Pack (&p)[4][3]) {
  const auto &x = shape.x, &d = shape.d;
  for (int s = 0; s < 2; ++s) {
    const int along = 1 + s, across = 2 - s;
    const Pack mean = force.mean[s], linear = force.linear[s];
    for (int i = 0; i < 3; ++i) {
      f[along][i] += mean * d[0][i] + linear * d[across][i];
      f[3][i] += mean * d[across][i] + linear * d[0][i];
      p[0][i] += mean * x[along][i] + linear * x[3][i];
      p[across][i] += mean * x[3][i] + linear * x[along][i];
    }
  }
}

/// u,xi and u,eta at the point.
BRUNT_INLINE void derivatives(const Shell4Point& point, const Pack (&u)[4][3], Pack (&xi)[3], Pack (&eta)[3]) {
  for (int i = 0; i < 3; ++i) {
    xi[i] = u[1][i] + point.eta * u[3][i];
    eta[i] = u[2][i] + point.xi * u[3][i];
  }
}
BRUNT_INLINE void add_derivative_forces(const Shell4Point& point, const Pack (&xi)[3], const Pack (&eta)[3],
                                        Pack (&f)[4][3]) {
  for (int i = 0; i < 3; ++i) {
    f[1][i] += xi[i];
    f[2][i] += eta[i];
    f[3][i] += point.eta * xi[i] + point.xi * eta[i];
  }
}

}  // namespace shell4_full_detail

}  // namespace brunt::element
