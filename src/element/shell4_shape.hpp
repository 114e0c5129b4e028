// SPDX-License-Identifier: Apache-2.0
// Strains of the one-point quadrilateral of a shell, linear in the velocities and rates of rotation of its corners, and
// their transpose, the forces: one and the same map, so that rigid motions give no strain and forces balance.
//
// A point at the height z over corner I moves with v_I + z p_I, p_I = r_I x d_I, the director d_I = n + t_I: n the
// normal of the centre, t_I the tilt of the warped surface at the corner. With the corners at z_h xi eta over the plane
// of a and b, the tilt is -grad(z_h xi eta) of the mean Jacobian, linear in xi and eta. In the axes of the shape:
//   L = grad v (3 x 2), P = grad p (2 x 2), K = grad t (symmetric)
//   membrane   sym L;   curvature  sym(P - L K), the first order in z of the layer's own gradient
//   shears     along the edges of eta = -1, 1 at their middles: v,xi . d + x,xi . p (K. J. Bathe, E. N. Dvorkin, Int.
//   J.
//              Numer. Meth. Eng. 21 (1985) 367): mean c_xi and difference l_xi eta; likewise c_eta and l_eta
//   drilling   r . n - spin, spin = (L_yx - L_xy)/2
//   hourglass  v_h - L h + h_z grad v_z in the plane, p_h - P h + L K h of the rotations
// Each vanishes in a rigid motion, whatever the shape. A deflection of second order with its own slopes gives no
// shears: constant bending is held on any flat quadrilateral.
#pragma once
#include "core/simd.hpp"
#include "element/shell_frame.hpp"

namespace brunt::element {

struct Shell4Shape {
  ShellTangents plane;
  Pack h[3];               ///< mode xi eta of the positions; h[2] is the warp
  Pack t_xi[2], t_eta[2];  ///< modes of the tilt
  Pack K[3];               ///< gradient of the tilt xx, yy, xy [1/length]
  Pack Kh[2];              ///< part of the tilt that is not linear in x and y, negative
  bool warped;

  /// From the modes of the positions in space.
  BRUNT_INLINE Shell4Shape(const Pack (&x)[4][3], bool warped_) : plane(x[1], x[2]), warped(warped_) {
    plane.axes.to_local(x[3], h);
    if (!warped) return;
    const auto& [axes, ax, by, c, J, over_J, length] = plane;
    const Pack w = h[2] * over_J, k = w * over_J;
    t_xi[0] = w * c;
    t_xi[1] = -w * ax;
    t_eta[0] = -w * by;
    t_eta[1] = w * c;
    K[0] = 2.0 * k * c * by;
    K[1] = 2.0 * k * c * ax;
    K[2] = -k * (c * c + ax * by);
    Kh[0] = K[0] * h[0] + K[2] * h[1];
    Kh[1] = K[2] * h[0] + K[1] * h[1];
  }
};

/// Strain rates [1/time, curvature 1/(length time), those of hourglass modes and of xi and eta length/time or 1/time].
struct Shell4Rates {
  Pack L[3][2], curvature[3], shear[2], spin;
  Pack linear_shear[2];                ///< l_xi, l_eta [length/time]
  Pack of_membrane[2], of_bending[2];  ///< hourglass modes [length/time], [1/time]
  Pack drilling[4];                    ///< modes of r . n less the spin [1/time]
};

/// Forces that do work on them, integrated over the element.
struct Shell4Stress {
  Pack membrane[3], moment[3], shear[2], linear_shear[2], of_membrane[2], of_bending[2], drilling[4];
};

namespace shell4_detail {

/// Modes of u t for t = xi t_xi + eta t_eta.
BRUNT_INLINE void times_tilt(const Pack (&u)[4], Pack t_xi, Pack t_eta, Pack (&product)[4]) {
  product[0] = u[1] * t_xi + u[2] * t_eta;
  product[1] = u[0] * t_xi + u[3] * t_eta;
  product[2] = u[3] * t_xi + u[0] * t_eta;
  product[3] = u[2] * t_xi + u[1] * t_eta;
}

/// r x d, or with sign -1 the transpose d x f; modes of the components, [component][mode].
BRUNT_INLINE void cross_director(const Shell4Shape& shape, double sign, const Pack (&r)[3][4], Pack (&p)[3][4]) {
  for (int m = 0; m < 4; ++m) {
    p[0][m] = sign * r[1][m];
    p[1][m] = -sign * r[0][m];
    p[2][m] = broadcast(0.0);
  }
  if (!shape.warped) return;
  Pack zy[4], zx[4], xy[4], yx[4];
  times_tilt(r[2], shape.t_xi[1], shape.t_eta[1], zy);
  times_tilt(r[2], shape.t_xi[0], shape.t_eta[0], zx);
  times_tilt(r[0], shape.t_xi[1], shape.t_eta[1], xy);
  times_tilt(r[1], shape.t_xi[0], shape.t_eta[0], yx);
  for (int m = 0; m < 4; ++m) {
    p[0][m] -= sign * zy[m];
    p[1][m] += sign * zx[m];
    p[2][m] += sign * (xy[m] - yx[m]);
  }
}

}  // namespace shell4_detail

/// v, r: modes of the components in the axes of the shape, [component][mode]; the mean of v has no part.
BRUNT_INLINE void shell4_rates(const Shell4Shape& shape, const Pack (&v)[3][4], const Pack (&r)[3][4],
                               Shell4Rates& rates) {
  const ShellTangents& plane = shape.plane;
  const auto& h = shape.h;
  auto& L = rates.L;
  Pack p[3][4], P[2][2];
  shell4_detail::cross_director(shape, 1, r, p);
  for (int i = 0; i < 3; ++i) plane.gradient(v[i][1], v[i][2], L[i][0], L[i][1]);
  for (int i = 0; i < 2; ++i) plane.gradient(p[i][1], p[i][2], P[i][0], P[i][1]);
  for (int i = 0; i < 2; ++i) {
    rates.of_membrane[i] = v[i][3] - (L[i][0] * h[0] + L[i][1] * h[1]) + h[2] * L[2][i];
    rates.of_bending[i] = p[i][3] - (P[i][0] * h[0] + P[i][1] * h[1]);
  }
  Pack along_xi = v[2][1] + plane.ax * p[0][0] + plane.c * p[1][0];
  Pack along_eta = v[2][2] + plane.c * p[0][0] + plane.by * p[1][0];
  Pack& l_xi = rates.linear_shear[0];
  Pack& l_eta = rates.linear_shear[1];
  l_xi = l_eta = v[2][3] + h[0] * p[0][0] + h[1] * p[1][0];
  l_xi += plane.ax * p[0][2] + plane.c * p[1][2];
  l_eta += plane.c * p[0][1] + plane.by * p[1][1];
  for (int i = 0; i < 2; ++i) {
    along_xi += h[i] * p[i][2];
    along_eta += h[i] * p[i][1];
  }
  if (shape.warped) {
    const auto& [t_x, t_y] = shape.t_xi;
    const auto& [s_x, s_y] = shape.t_eta;
    along_xi += v[0][3] * s_x + v[1][3] * s_y + h[2] * p[2][2];
    along_eta += v[0][3] * t_x + v[1][3] * t_y + h[2] * p[2][1];
    l_xi += v[0][1] * s_x + v[1][1] * s_y + h[2] * p[2][0];
    l_eta += v[0][2] * t_x + v[1][2] * t_y + h[2] * p[2][0];
    for (int i = 0; i < 2; ++i) {
      rates.of_bending[i] += L[i][0] * shape.Kh[0] + L[i][1] * shape.Kh[1];
      const Pack x = L[i][0] * shape.K[0] + L[i][1] * shape.K[2], y = L[i][0] * shape.K[2] + L[i][1] * shape.K[1];
      P[i][0] -= x;
      P[i][1] -= y;
    }
  }
  plane.gradient(along_xi, along_eta, rates.shear[0], rates.shear[1]);
  rates.curvature[0] = P[0][0];
  rates.curvature[1] = P[1][1];
  rates.curvature[2] = 0.5 * (P[0][1] + P[1][0]);
  rates.spin = 0.5 * (L[1][0] - L[0][1]);
  for (int m = 0; m < 4; ++m) rates.drilling[m] = r[2][m];
  rates.drilling[0] -= rates.spin;
}

/// The transpose of `shell4_rates`: forces f and moments m on the modes.
BRUNT_INLINE void shell4_forces(const Shell4Shape& shape, const Shell4Stress& stress, Pack (&f)[3][4],
                                Pack (&m)[3][4]) {
  const ShellTangents& plane = shape.plane;
  const auto& h = shape.h;
  const auto& N = stress.membrane;
  const auto& M = stress.moment;
  const auto &Q = stress.of_membrane, &B = stress.of_bending;
  Pack S[3][2] = {{N[0], N[2]}, {N[2], N[1]}, {h[2] * Q[0], h[2] * Q[1]}}, D[2][2] = {{M[0], M[2]}, {M[2], M[1]}};
  if (shape.warped)
    for (int i = 0; i < 2; ++i) {
      S[i][0] += B[i] * shape.Kh[0] - (D[i][0] * shape.K[0] + D[i][1] * shape.K[2]);
      S[i][1] += B[i] * shape.Kh[1] - (D[i][0] * shape.K[2] + D[i][1] * shape.K[1]);
    }
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      S[i][j] -= Q[i] * h[j];
      D[i][j] -= B[i] * h[j];
    }
  S[0][1] += 0.5 * stress.drilling[0];
  S[1][0] -= 0.5 * stress.drilling[0];
  Pack p[3][4], along_xi, along_eta;  // p: on the modes of r x d
  for (int i = 0; i < 3; ++i) plane.gradient(S[i][0], S[i][1], f[i][1], f[i][2]);
  for (int i = 0; i < 2; ++i) plane.gradient(D[i][0], D[i][1], p[i][1], p[i][2]);
  plane.gradient(stress.shear[0], stress.shear[1], along_xi, along_eta);
  const auto& [l_xi, l_eta] = stress.linear_shear;
  const Pack both = l_xi + l_eta;
  for (int i = 0; i < 2; ++i) {
    f[i][0] = broadcast(0.0);
    f[i][3] = Q[i];
    p[i][3] = B[i];
    p[i][0] = both * h[i];
    p[i][1] += along_eta * h[i];
    p[i][2] += along_xi * h[i];
  }
  f[2][0] = broadcast(0.0);
  f[2][1] += along_xi;
  f[2][2] += along_eta;
  f[2][3] = both;
  p[0][0] += plane.ax * along_xi + plane.c * along_eta;
  p[1][0] += plane.c * along_xi + plane.by * along_eta;
  p[0][2] += plane.ax * l_xi;
  p[1][2] += plane.c * l_xi;
  p[0][1] += plane.c * l_eta;
  p[1][1] += plane.by * l_eta;
  p[2][0] = both * h[2];
  p[2][1] = along_eta * h[2];
  p[2][2] = along_xi * h[2];
  p[2][3] = broadcast(0.0);
  if (shape.warped)
    for (int i = 0; i < 2; ++i) {
      f[i][3] += along_xi * shape.t_eta[i] + along_eta * shape.t_xi[i];
      f[i][1] += l_xi * shape.t_eta[i];
      f[i][2] += l_eta * shape.t_xi[i];
    }
  shell4_detail::cross_director(shape, -1, p, m);
  for (int k = 0; k < 4; ++k) m[2][k] += stress.drilling[k];
}

}  // namespace brunt::element
