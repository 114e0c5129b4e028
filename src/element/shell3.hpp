// SPDX-License-Identifier: Apache-2.0
// The triangle of a shell with constant strains and one point in its plane, for a batch of elements at once.
//
// Fields are u = u_m + u_X X + u_Y Y in the coordinates of an equilateral triangle of edge 1, with the tangents a = x_X
// and b = x_Y; the axes are those of the polar decomposition of [a b] and turn with the corners. A point at the height
// z moves with v + z p, p = r x n:
//   membrane sym grad v, curvature sym grad p
//   shears   those along the edges at their middles, v . n and p . x (P. S. Lee, K. J. Bathe, Comput. Struct. 82 (2004)
//            945). With S_XY the covariant components of sym grad p, their field is e_X = v_X . n + p_m . a -
//            2 k S_XY + l Y, e_Y = v_Y . n + p_m . b - k (S_XX - S_YY) - l X, k = 1/(4 sqrt 3), l = (a . p_Y - b .
//            p_X)/2
// Stresses see the mean. The rest, l, has a spring, without which it would have no energy; in full it would lock thin
// shells, so its stiffness is that of shear times h^2/(h^2 + A/10) (M. Lyly, R. Stenberg, T. Vihinen, Comput. Methods
// Appl. Mech. Eng. 110 (1993) 343). Constant bending gives no shear on any triangle.
#pragma once
#include <cmath>
#include <vector>

#include "element/batch.hpp"
#include "element/options.hpp"
#include "element/shell_batch.hpp"
#include "element/shell_drilling.hpp"
#include "element/shell_frame.hpp"
#include "element/shell_layers.hpp"
#include "element/shell_step.hpp"

namespace brunt::element {

template <class Response>
struct Shell3 {
  static constexpr int nodes = 3, fibres = 1;
  using Memory = ShellMemory<Response, 1>;
  static constexpr int most_history = Memory::most + 5;

  Response law;
  ShellSection section;

  [[nodiscard]] std::vector<HistoryField> history() const {
    std::vector<HistoryField> fields = Memory(section).fields(law, section.thickness);
    fields.push_back({"hourglass_force", 1});
    fields.push_back({"drilling_moment", 3});
    fields.push_back({"hourglass_energy", 1});
    return fields;
  }

  void operator()(const ShellMotion<3>& in, const Pack* committed, Pack* trial, ShellForce<3>& out) const;
};

namespace shell3_detail {

constexpr double over_root3 = 0.57735026918962576451, tied = 0.25 * over_root3;
constexpr double area_of_unit = 0.43301270189221932338;  ///< of the equilateral triangle, sqrt(3)/4
constexpr double spin_length2 = 0.1;                     ///< Lyly, Stenberg, Vihinen: times A

/// Mean, X and Y modes of the components, [mode][component].
BRUNT_INLINE void modes_of(const Pack (&u)[3][3], Pack (&mode)[3][3]) {
  for (int i = 0; i < 3; ++i) {
    const Pack pair = u[i][0] + u[i][1];
    mode[0][i] = (1.0 / 3.0) * (pair + u[i][2]);
    mode[1][i] = u[i][1] - u[i][0];
    mode[2][i] = over_root3 * (2.0 * u[i][2] - pair);
  }
}

/// Minus the forces on the modes in these axes, on the corners in space.
BRUNT_INLINE void to_corners(const ShellAxes& axes, const Pack (&local)[3][3], Pack (&corner)[3][3]) {
  Pack mode[3][3];
  for (int m = 0; m < 3; ++m) axes.to_global(local[m], mode[m]);
  for (int i = 0; i < 3; ++i) {
    const Pack third = (1.0 / 3.0) * mode[0][i], y = over_root3 * mode[2][i];
    corner[i][0] = mode[1][i] + y - third;
    corner[i][1] = y - mode[1][i] - third;
    corner[i][2] = -(2.0 * y + third);
  }
}

struct Rates {
  Pack L[2][2], P[2][2], shear[2], linear_shear, spin, drilling[3];
  Pack turn_x, turn_y;  ///< rate of the vector that the axes follow
};

/// v, r: modes in the axes of `plane`.
BRUNT_INLINE Rates rates_of(const ShellTangents& plane, const Pack (&v)[3][3], const Pack (&r)[3][3]) {
  Rates rates;
  Pack p[3][2];
  for (int m = 0; m < 3; ++m) {
    p[m][0] = r[m][1];
    p[m][1] = -r[m][0];
  }
  for (int i = 0; i < 2; ++i) {
    plane.gradient(v[1][i], v[2][i], rates.L[i][0], rates.L[i][1]);
    plane.gradient(p[1][i], p[2][i], rates.P[i][0], rates.P[i][1]);
  }
  const auto along_a = [&](const Pack(&u)[2]) { return plane.ax * u[0] + plane.c * u[1]; };
  const auto along_b = [&](const Pack(&u)[2]) { return plane.c * u[0] + plane.by * u[1]; };
  const Pack xy = along_a(p[2]), yx = along_b(p[1]);
  const Pack e_x = v[1][2] + along_a(p[0]) - tied * (xy + yx);
  const Pack e_y = v[2][2] + along_b(p[0]) - tied * (along_a(p[1]) - along_b(p[2]));
  plane.gradient(e_x, e_y, rates.shear[0], rates.shear[1]);
  rates.linear_shear = 0.5 * (xy - yx);
  rates.spin = 0.5 * (rates.L[1][0] - rates.L[0][1]);
  for (int m = 0; m < 3; ++m) rates.drilling[m] = r[m][2];
  rates.drilling[0] -= rates.spin;
  rates.turn_x = v[1][0] + v[2][1];
  rates.turn_y = v[1][1] - v[2][0];
  return rates;
}

/// The transpose: forces and moments on the modes. N, M, Q, l, drilling: stresses times the area.
BRUNT_INLINE void forces_of(const ShellTangents& plane, const Pack (&N)[3], const Pack (&M)[3], const Pack (&Q)[2],
                            Pack l, const Pack (&drilling)[3], Pack (&f)[3][3], Pack (&m)[3][3]) {
  Pack p[3][2], e_x, e_y;
  plane.gradient(N[0], N[2] + 0.5 * drilling[0], f[1][0], f[2][0]);
  plane.gradient(N[2] - 0.5 * drilling[0], N[1], f[1][1], f[2][1]);
  plane.gradient(Q[0], Q[1], e_x, e_y);
  plane.gradient(M[0], M[2], p[1][0], p[2][0]);
  plane.gradient(M[2], M[1], p[1][1], p[2][1]);
  f[1][2] = e_x;
  f[2][2] = e_y;
  const Pack a[2] = {plane.ax, plane.c}, b[2] = {plane.c, plane.by};
  const Pack x = tied * e_x, y = tied * e_y, half = 0.5 * l;
  for (int i = 0; i < 2; ++i) {
    p[0][i] = a[i] * e_x + b[i] * e_y;
    p[1][i] -= a[i] * y + b[i] * (x + half);
    p[2][i] += b[i] * y - a[i] * (x - half);
  }
  for (int k = 0; k < 3; ++k) {
    f[0][k] = broadcast(0.0);
    m[k][0] = -p[k][1];
    m[k][1] = p[k][0];
    m[k][2] = drilling[k];
  }
}

/// In the modes the mass is m on the means, m/6 on X and Y; J and J/6. Squares of frequencies over A h/m, by what the
/// groups charge to p_X and p_Y: shear, bending and the spring of l, whose stiffness is `spin` on l^2.
struct Charges {
  Pack membrane, shear, inertia;  ///< 6 M; 6 k mu g; what m/J multiplies
};
BRUNT_INLINE Charges charges_of(const ShellTangents& plane, const ShellModuli& moduli, Pack stress, Pack square,
                                Pack spin, Pack drilling) {
  Pack largest, trace;
  plane.metric(largest, trace);
  const Pack edges = plane.ax * plane.ax + plane.by * plane.by + 2.0 * plane.c * plane.c;
  const Pack membrane = 6.0 * moduli.in_plane(stress, largest, trace), shear = moduli.shear + stress;
  const Pack inertia =
      shear * (1.0 + 0.125 * largest * edges) + square * membrane + 1.5 * edges * spin + 2.0 * drilling;
  return {membrane, 6.0 * shear * largest, inertia};
}

/// Of l, over A h: in full k mu tr g/24.
BRUNT_INLINE Pack spin_stiffness(const ShellTangents& plane, const ShellModuli& moduli, Pack height2) {
  const Pack area = area_of_unit * plane.J, over = plane.over_J * plane.over_J;
  const Pack trace = (plane.ax * plane.ax + plane.by * plane.by + 2.0 * plane.c * plane.c) * over;
  return (moduli.shear / 24) * trace * (height2 / (height2 + spin_length2 * area));
}

}  // namespace shell3_detail

/// Rotary inertia of a whole element, a third for each corner: with it the sum of what shear and bending charge is no
/// more than the membrane's share. Parameters as of the quadrilateral (shell4_step.hpp).
BRUNT_INLINE Pack rotary_inertia(const Pack (&x)[3][3], Pack mass, Pack thickness, double offset, double lambda,
                                 double mu) {
  using namespace shell3_detail;
  Pack mode[3][3];
  modes_of(x, mode);
  const ShellTangents plane(mode[1], mode[2]);
  const ShellModuli moduli(lambda, mu);
  const Pack height2 = thickness * thickness, none = broadcast(0.0);
  const Charges charges =
      charges_of(plane, moduli, none, (1.0 / 12 + offset * offset) * height2, spin_stiffness(plane, moduli, height2),
                 drilling_stiffness(mu, thickness, (1 / area_of_unit) * plane.over_J));
  return mass * (charges.inertia / pack_max(charges.membrane - charges.shear, 0.1 * charges.membrane));
}

template <class Response>
void Shell3<Response>::operator()(const ShellMotion<3>& in, const Pack* committed, Pack* trial,
                                  ShellForce<3>& out) const {
  using namespace shell3_detail;
  const Memory memory(section);
  const double dt = in.dt;
  Pack x[3][3], v[3][3], r[3][3], x_mid[3][3], v_mid[3][3], r_mid[3][3];
  modes_of(in.x, x);
  modes_of(in.v, v);
  modes_of(in.r, r);
  for (int m = 1; m < 3; ++m)
    for (int i = 0; i < 3; ++i) x_mid[m][i] = x[m][i] - (0.5 * dt) * v[m][i];
  const ShellTangents middle(x_mid[1], x_mid[2]);
  for (int m = 0; m < 3; ++m) {
    middle.axes.to_local(v[m], v_mid[m]);
    middle.axes.to_local(r[m], r_mid[m]);
  }
  const Rates rates = rates_of(middle, v_mid, r_mid);
  const PlaneTurn turn = plane_turn(dt * rates.spin, middle.length, dt * rates.turn_x, dt * rates.turn_y);
  ShellStrain strain;
  for (int c = 0; c < 2; ++c) {
    strain.membrane[c] = dt * rates.L[c][c];
    strain.curvature[c] = dt * rates.P[c][c];
    strain.shear[c] = (0.5 * dt) * rates.shear[c];
  }
  strain.membrane[2] = (0.5 * dt) * (rates.L[0][1] + rates.L[1][0]);
  strain.curvature[2] = (0.5 * dt) * (rates.P[0][1] + rates.P[1][0]);
  strain.see_from_end(turn);

  ShellResultants sum;
  Pack thickness = committed[Memory::at_thickness];
  follow_fibre(law, section, thickness, strain, turn, dt, memory.fibre(committed), memory.fibre(trial), sum);
  if (section.thinning) thickness = thinned(thickness, sum.normal_strain);
  trial[Memory::at_thickness] = thickness;
  scale(sum, thickness);

  const ShellTangents end(x[1], x[2]);
  const ShellModuli moduli(law.lambda, law.mu);
  const Pack area = area_of_unit * end.J, volume = area * thickness, height2 = thickness * thickness;
  const Pack spring = spin_stiffness(end, moduli, height2);
  const int at = memory.size();
  const Pack before = committed[at], increment = (dt * volume) * spring * rates.linear_shear;
  const Pack l = (1.0 - sum.lost) * (before + increment);
  trial[at] = l;
  Pack work = (0.5 * dt) * (before + l) * rates.linear_shear, moment[3];
  const Pack drilling = drilling_stiffness(law.mu, thickness, (1 / area_of_unit) * end.over_J);
  resist_drilling(rates.drilling, {1, 1.0 / 6, 1.0 / 6}, volume * drilling, 1.0 - sum.lost_in_bending, dt,
                  committed + at + 1, trial + at + 1, work, moment);
  trial[at + 4] = committed[at + 4] + work;

  Pack N[3], M[3], f[3][3], m[3][3];
  for (int c = 0; c < 3; ++c) {
    N[c] = area * sum.force[c];
    M[c] = area * sum.moment[c];
  }
  const Pack Q[2] = {area * sum.shear[0], area * sum.shear[1]};
  forces_of(end, N, M, Q, l, moment, f, m);
  to_corners(end.axes, f, out.f);
  to_corners(end.axes, m, out.m);

  const double mean = std::abs(section.offset), second = thickness_points(section).second + mean * mean;
  const Pack mass = committed[at_shell_mass], inertia = committed[at_rotary_inertia];
  const Pack over_both = 1.0 / (mass * inertia), over_inertia = over_both * (mass * mass);
  const Charges charges = charges_of(end, moduli, pack_sqrt(sum.stress2), second * height2, spring, drilling);
  Pack coupling = broadcast(0.0);
  if (mean > 0) coupling = charges.membrane * (mean * thickness) * pack_sqrt(over_inertia);
  const Pack largest = pack_max(charges.membrane, charges.shear + over_inertia * charges.inertia) + coupling;
  out.rate = stable_rate(volume * (over_both * inertia) * largest, broadcast(0.0));
  out.volume = volume;
}

}  // namespace brunt::element
