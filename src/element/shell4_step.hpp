// SPDX-License-Identifier: Apache-2.0
// Stable step and rotary inertia of the one-point quadrilateral of a shell.
//
// In the modes of the corners the mass is m on each mode of v and J on each of r. All squares of frequencies here are
// over A h/m. With g and tr g the largest eigenvalue and the trace of the reciprocal metric, p = m <z^2>/J,
// H = |h|^2 g (zero for parallelograms), tau a bound of |t|^2 (zero for flat elements), k the norm of K sqrt(<z^2>):
//   v,xi v,eta in the plane   membrane  M = lambda tr g + 2 mu g, times (1 + k)^2 + coupling
//   v,xi v,eta v_h normal, r_m    shear   k mu (g + m/J)(1 + tau)(1 + (H + tau)/slack)
//   r_xi, r_eta, r_z          bending  p (1 + tau) M + coupling, shear k mu (m/J)(H + tau + slack), l_xi,
//                             l_eta, twice the drilling springs (the other half of (r - spin)^2 < 2 r^2 + 2 spin^2 adds
//                             no more to the membrane's share than 2 mu g holds for the spin)
//   v_h, r_h                  hourglass, charged twice where H > 0
// coupling = (|<z>| sqrt(m/J) + k (1 + p)/2) M, as k sqrt(p) is at most; slack = 1 - p is what bending leaves of the
// membrane's share.
#pragma once
#include "element/options.hpp"
#include "element/shell4_shape.hpp"
#include "element/shell_step.hpp"

namespace brunt::element {

/// Springs of hourglass modes, over A h: coefficient times half of the stiffness of unit modes.
struct Shell4Springs {
  Pack membrane, bending, shear[2];
};

/// E tr g/2 on v_h and, with the second moment of the points about the middle, on p_h; half of the shear stiffness of
/// fields l_xi eta and l_eta xi.
BRUNT_INLINE Shell4Springs shell4_springs(const Shell4Shape& shape, const ShellModuli& moduli, double coefficient,
                                          Pack trace, Pack moment) {
  const ShellTangents& q = shape.plane;
  const Pack over2 = q.over_J * q.over_J, half = broadcast(0.5 * coefficient), cc = q.c * q.c;
  Shell4Springs springs;
  springs.membrane = half * moduli.young * trace;
  springs.bending = springs.membrane * moment;
  springs.shear[0] = half * moduli.shear * over2 * (q.by * q.by + cc);
  springs.shear[1] = half * moduli.shear * over2 * (q.ax * q.ax + cc);
  return springs;
}

struct Shell4Bounds {
  Pack largest, trace;        ///< of the reciprocal metric
  Pack over_inertia;          ///< m/J
  Pack drilling;              ///< its stiffness
  Pack square, mean, moment;  ///< <z^2>, |<z>|, <z^2> about the middle
  Pack radius;                ///< sqrt(<z^2>)
  Pack stress;                ///< bound of the norm of the stress
};

/// Bounds of |t|^2 and of the spectral norm of K, by its rows.
BRUNT_INLINE void tilt_bounds(const Shell4Shape& shape, Pack& tau, Pack& norm) {
  tau = norm = broadcast(0.0);
  if (!shape.warped) return;
  for (int i = 0; i < 2; ++i) tau += 2.0 * (shape.t_xi[i] * shape.t_xi[i] + shape.t_eta[i] * shape.t_eta[i]);
  norm = pack_max(pack_abs(shape.K[0]), pack_abs(shape.K[1])) + pack_abs(shape.K[2]);
}

/// Sums of the squares of the norms of springs (or dashpots): on v_h, p_h and what of them is in L and P; on l_xi,
/// l_eta.
struct Shell4HourglassBounds {
  Pack modes, linear;
};
BRUNT_INLINE Shell4HourglassBounds shell4_hourglass(const Shell4Shape& shape, const Shell4Springs& springs,
                                                    const Shell4Bounds& b) {
  const auto& h = shape.h;
  const ShellTangents& q = shape.plane;
  Pack tau, norm;
  tilt_bounds(shape, tau, norm);
  const Pack inertia = b.over_inertia * (1.0 + tau), all2 = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
  const Pack kk = norm * norm;
  const Pack aa = q.ax * q.ax + q.c * q.c + all2, bb = q.by * q.by + q.c * q.c + all2;
  const Pack lever = 1.0 + b.mean * b.mean * (inertia + kk);  // the springs see the middle of the shell
  return {
      springs.membrane * lever + springs.bending * (inertia + kk),
      (springs.shear[0] + springs.shear[1]) * (1.0 + tau) + inertia * (springs.shear[0] * aa + springs.shear[1] * bb)};
}

/// H: zero for parallelograms.
BRUNT_INLINE Pack hourglass_share(const Shell4Shape& shape, const Shell4Bounds& b) {
  return (shape.h[0] * shape.h[0] + shape.h[1] * shape.h[1] + shape.h[2] * shape.h[2]) * b.largest;
}

/// Square of the largest frequency over A h/m.
BRUNT_INLINE Pack shell4_frequency(const Shell4Shape& shape, const ShellModuli& moduli, const Shell4Springs& springs,
                                   const Shell4Bounds& b, bool offset) {
  const Pack H = hourglass_share(shape, b);
  const Pack membrane = moduli.in_plane(b.stress, b.largest, b.trace), shear = moduli.shear + b.stress;
  Pack tau, norm;
  tilt_bounds(shape, tau, norm);
  const Pack inertia = b.over_inertia * (1.0 + tau);
  const Pack p = b.square * inertia, slack = pack_max(1.0 - p, broadcast(0.05)), delta = H + tau;
  const Pack k = norm * b.radius;
  Pack coupling = 0.5 * k * (1.0 + p);
  if (offset) coupling += b.mean * pack_sqrt(inertia);
  const Pack of_membrane = membrane * ((1.0 + k) * (1.0 + k) + coupling);
  const Pack of_shear = shear * (b.largest + b.over_inertia) * (1.0 + tau) * (1.0 + delta / slack);
  const auto [modes, linear] = shell4_hourglass(shape, springs, b);
  const Pack of_bending =
      membrane * (p + coupling) + shear * inertia * (delta + slack) + linear + 2.0 * b.drilling * b.over_inertia;
  const Pack strains = pack_max(pack_max(of_membrane, of_shear), of_bending);
  return pack_max(strains + 2.0 * modes * H + linear * pack_min(delta, broadcast(1.0)), 2.0 * modes * (1.0 + H));
}

/// Rotary inertia of a whole element, an equal share of it for each corner: that of its fibres, or as much as the shear
/// needs not to govern the step (inertia_over_mass). x: corners at the start; mass and thickness of the element, offset
/// in thicknesses; lambda, mu: Lame's constants of the virgin solid.
BRUNT_INLINE Pack rotary_inertia(const Pack (&x)[3][4], Pack mass, Pack thickness, double offset, double lambda,
                                 double mu) {
  Pack a[3], b[3], largest, trace;
  for (int i = 0; i < 3; ++i) {
    Pack mode[4];
    to_quad_modes(x[i], mode);
    a[i] = mode[1];
    b[i] = mode[2];
  }
  ShellTangents(a, b).metric(largest, trace);
  const Pack bending = (1.0 / 12 + offset * offset) * thickness * thickness;
  return mass * inertia_over_mass(ShellModuli(lambda, mu), largest, trace, bending);
}

}  // namespace brunt::element
