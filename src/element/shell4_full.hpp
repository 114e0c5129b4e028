// SPDX-License-Identifier: Apache-2.0
// The quadrilateral of a shell with 2 x 2 points in its plane and assumed transverse shears, for a batch of elements at
// once. Strains and forces: shell4_full_shape.hpp; stresses through the thickness: shell_layers.hpp.
//
// Stable step. In the modes of the corners the mass is m on each mode of v and J on each of r, and |p| <= |r|. With
// M = lambda tr g + 2 mu g of a point, g and tr g of its reciprocal metric, and its Jacobian j:
//   membrane  4 max(j M) on v,xi v,eta (2/3 of it on v_h), bending m <z^2>/J times it on p; curved elements: see
//   `bound` shear     at a point |grad|^2 <= (1 + cos) (e_xi^2 |grad xi|^2 + e_eta^2 |grad eta|^2)
#pragma once
#include <cmath>
#include <vector>

#include "element/batch.hpp"
#include "element/options.hpp"
#include "element/shell4_full_shape.hpp"
#include "element/shell_batch.hpp"
#include "element/shell_drilling.hpp"
#include "element/shell_layers.hpp"
#include "element/shell_step.hpp"

namespace brunt::element {

template <class Response>
struct Shell4Full {
  static constexpr int nodes = 4, fibres = 4;
  using Memory = ShellMemory<Response, fibres>;
  static constexpr int most_history = Memory::most + 5;

  Response law;
  ShellSection section;

  [[nodiscard]] std::vector<HistoryField> history() const {
    std::vector<HistoryField> fields = Memory(section).fields(law, section.thickness);
    fields.push_back({"drilling_moment", 4});
    fields.push_back({"hourglass_energy", 1});
    return fields;
  }

  void operator()(const ShellMotion<4>& in, const Pack* committed, Pack* trial, ShellForce<4>& out) const;

 private:
  /// Largest of the points, for the bound of the step.
  struct Largest {
    Pack membrane{}, curved{}, shear[2]{}, skew{}, metric{};
  };
  BRUNT_INLINE void note(const Shell4Point& point, const ShellModuli& moduli, Pack stress, Largest& largest) const;
  BRUNT_INLINE Pack bound(const Shell4FullShape& shape, const Largest& largest, Pack over_inertia, Pack thickness,
                          Pack square, Pack drilling) const;
};

namespace shell4_full_detail {

/// Strain increment of a step at a point, seen from its end, and the turn of stresses.
BRUNT_INLINE void strain_at(const Shell4Point& point, const Pack (&v)[4][3], const Pack (&p)[4][3],
                            const EdgeShears& edges, double dt, ShellStrain& strain, PlaneTurn& turn) {
  const auto& plane = point.plane;
  const auto& e = plane.axes.e;
  Pack v_xi[3], v_eta[3], p_xi[3], p_eta[3], xx, xy, yx, yy, g_x, g_y;
  derivatives(point, v, v_xi, v_eta);
  derivatives(point, p, p_xi, p_eta);
  const Pack x_xi = dot(e[0], v_xi), x_eta = dot(e[0], v_eta), y_xi = dot(e[1], v_xi), y_eta = dot(e[1], v_eta);
  plane.gradient(x_xi, x_eta, xx, xy);
  plane.gradient(y_xi, y_eta, yx, yy);
  turn = plane_turn((0.5 * dt) * (yx - xy), plane.length, dt * (x_xi + y_eta), dt * (y_xi - x_eta));
  const Pack covariant[3] = {
      dot(point.a, p_xi) + dot(point.da, v_xi), dot(point.b, p_eta) + dot(point.db, v_eta),
      0.5 * (dot(point.a, p_eta) + dot(point.b, p_xi) + dot(point.da, v_eta) + dot(point.db, v_xi))};
  point.transform(covariant, strain.curvature);
  plane.gradient(edges.mean[0] + point.eta * edges.linear[0], edges.mean[1] + point.xi * edges.linear[1], g_x, g_y);
  strain.membrane[0] = dt * xx;
  strain.membrane[1] = dt * yy;
  strain.membrane[2] = (0.5 * dt) * (xy + yx);
  for (Pack& c : strain.curvature) c *= dt;
  strain.shear[0] = (0.5 * dt) * g_x;
  strain.shear[1] = (0.5 * dt) * g_y;
  strain.see_from_end(turn);
}

/// Forces of the resultants at a point on the modes of v and p, and on the shears of the edges.
BRUNT_INLINE void add_point(const Shell4Point& point, const ShellResultants& sum, Pack (&f)[4][3], Pack (&p)[4][3],
                            EdgeShears& edges) {
  const auto& plane = point.plane;
  Pack N[3], M[3], xi[3], eta[3], q_xi, q_eta;
  point.transform(sum.force, N);
  point.transform(sum.moment, M);
  for (Pack& c : N) c *= plane.J;
  for (Pack& c : M) c *= plane.J;
  for (int i = 0; i < 3; ++i) {
    xi[i] = N[0] * point.a[i] + N[2] * point.b[i] + M[0] * point.da[i] + M[2] * point.db[i];
    eta[i] = N[2] * point.a[i] + N[1] * point.b[i] + M[2] * point.da[i] + M[1] * point.db[i];
  }
  add_derivative_forces(point, xi, eta, f);
  for (int i = 0; i < 3; ++i) {
    xi[i] = M[0] * point.a[i] + M[2] * point.b[i];
    eta[i] = M[2] * point.a[i] + M[1] * point.b[i];
  }
  add_derivative_forces(point, xi, eta, p);
  plane.gradient(sum.shear[0], sum.shear[1], q_xi, q_eta);
  q_xi *= plane.J;
  q_eta *= plane.J;
  edges.mean[0] += q_xi;
  edges.linear[0] += point.eta * q_xi;
  edges.mean[1] += q_eta;
  edges.linear[1] += point.xi * q_eta;
}

/// Modes of r . n less the spin, about the normal at the centre.
BRUNT_INLINE void drilling_rates(const Shell4FullShape& shape, const Pack (&v)[4][3], const Pack (&r)[4][3],
                                 Pack (&rate)[4]) {
  const ShellTangents plane(shape.x[1], shape.x[2]);
  const auto& e = plane.axes.e;
  Pack xx, xy, yx, yy;
  plane.gradient(dot(e[0], v[1]), dot(e[0], v[2]), xx, xy);
  plane.gradient(dot(e[1], v[1]), dot(e[1], v[2]), yx, yy);
  for (int m = 0; m < 4; ++m) rate[m] = dot(e[2], r[m]);
  rate[0] -= 0.5 * (yx - xy);
}

/// The transpose, added to forces and moments on the modes.
BRUNT_INLINE void add_drilling(const Shell4FullShape& shape, const Pack (&moment)[4], Pack (&f)[4][3],
                               Pack (&m)[4][3]) {
  const ShellTangents plane(shape.x[1], shape.x[2]);
  const auto& e = plane.axes.e;
  const Pack half = 0.5 * moment[0], none = broadcast(0.0);
  Pack xi[2], eta[2];
  plane.gradient(none, half, xi[0], eta[0]);
  plane.gradient(-half, none, xi[1], eta[1]);
  for (int i = 0; i < 3; ++i) {
    f[1][i] += xi[0] * e[0][i] + xi[1] * e[1][i];
    f[2][i] += eta[0] * e[0][i] + eta[1] * e[1][i];
    for (int k = 0; k < 4; ++k) m[k][i] = moment[k] * e[2][i];
  }
}

/// Minus the corner values of forces on the modes [mode][component].
BRUNT_INLINE void to_corners(const Pack (&mode)[4][3], Pack (&corner)[3][4]) {
  for (int i = 0; i < 3; ++i) {
    const Pack of_component[4] = {-mode[0][i], -mode[1][i], -mode[2][i], -mode[3][i]};
    from_quad_modes(of_component, corner[i]);
  }
}

}  // namespace shell4_full_detail

template <class Response>
void Shell4Full<Response>::note(const Shell4Point& point, const ShellModuli& moduli, Pack stress,
                                Largest& largest) const {
  using shell4_full_detail::dot;
  const auto& q = point.plane;
  const Pack over2 = q.over_J * q.over_J, cc = q.c * q.c;
  const Pack aa = q.ax * q.ax + cc, bb = q.by * q.by + cc, ab = q.c * (q.ax + q.by);
  Pack metric, trace;
  q.metric(metric, trace);
  // |T^T d,a|^2 of the directors, all three components
  const Pack curved =
      over2 * (bb * dot(point.da, point.da) + aa * dot(point.db, point.db) - 2.0 * ab * dot(point.da, point.db));
  const Pack cosine = pack_abs(ab) / pack_sqrt(aa * bb);
  const Pack weight = q.J * (moduli.shear + stress) * (1.0 + cosine) * over2;
  largest.membrane = pack_max(largest.membrane, q.J * moduli.in_plane(stress, metric, trace));
  largest.curved = pack_max(largest.curved, curved);
  largest.shear[0] = pack_max(largest.shear[0], weight * bb);
  largest.shear[1] = pack_max(largest.shear[1], weight * aa);
  largest.skew = pack_max(largest.skew, cosine);
  largest.metric = pack_max(largest.metric, metric);
}

/// Square of the largest frequency over h/m. D = 1 - |d_m|^2 (zero where flat) bounds the squares of the other modes of
/// the directors, H as of the one-point element those of x_h; of_v = k mu g and of_p = k mu m/J. The mean shears are
/// c = v,xi . d_m + a . p_m and small parts of v_h and p_eta; a third of the squares of the differences,
/// l = v_h . d_m + a . p_eta and small parts of v,xi and p_m, counts. By shell_step.hpp, with e = (D + H)/slack for c,
/// 1/4 for l and once more 1/4 between v_h and p_eta:
///   v,xi v,eta p_m   (of_v + of_p) (1 + e + 5/3 (D + H))
///   v_h              (its parts of both directions) (25/12 + D + H + slack)
///   p_xi p_eta       of_p (25/48 + D + H + slack) + bending
template <class Response>
Pack Shell4Full<Response>::bound(const Shell4FullShape& shape, const Largest& largest, Pack over_inertia,
                                 Pack thickness, Pack square, Pack drilling) const {
  using shell4_full_detail::dot;
  const auto& x = shape.x;
  const Pack aa = dot(x[1], x[1]), bb = dot(x[2], x[2]), hh = dot(x[3], x[3]);
  const Pack edge_xi = aa + hh + 2.0 * pack_abs(dot(x[1], x[3]));
  const Pack edge_eta = bb + hh + 2.0 * pack_abs(dot(x[2], x[3]));
  const Pack D = pack_max(1.0 - dot(shape.d[0], shape.d[0]), broadcast(0.0)), H = hh * largest.metric;
  const Pack p = square * over_inertia, k = pack_sqrt(largest.curved * square);
  Pack coupling = 0.5 * k * (1.0 + p);
  if (section.offset != 0) coupling += (std::abs(section.offset) * thickness) * pack_sqrt(over_inertia);
  const Pack membrane = largest.membrane * ((1.0 + k) * (1.0 + k) + coupling);
  const Pack of_v = pack_max(largest.shear[0], largest.shear[1]);
  const Pack of_p =
      pack_max(largest.shear[0] * edge_xi, largest.shear[1] * edge_eta) * (1.0 + largest.skew) * over_inertia;
  const Pack small = D + H, slack = pack_max(0.45 - p, broadcast(0.05));
  const Pack twice = 0.5 * drilling * over_inertia;  // of (r - spin)^2; part of it in the rest where directors differ
  const Pack shear =
      (of_v + of_p) * (1.0 + small / slack + (5.0 / 3.0) * small) + twice * pack_min(4.0 * small, broadcast(1.0));
  const Pack of_mode = (largest.shear[0] + largest.shear[1]) * (25.0 / 12.0 + small + slack);
  const Pack bending = largest.membrane * (p + coupling) + of_p * (25.0 / 48.0 + small + slack) + twice;
  return 4.0 * pack_max(pack_max(membrane, shear), pack_max(bending, of_mode));
}

template <class Response>
void Shell4Full<Response>::operator()(const ShellMotion<4>& in, const Pack* committed, Pack* trial,
                                      ShellForce<4>& out) const {
  using namespace shell4_full_detail;
  const Memory memory(section);
  const double dt = in.dt;
  Pack x_mid[3][4], p_corner[3][4], v[4][3], r[4][3], p[4][3];
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 4; ++c) x_mid[i][c] = in.x[i][c] - (0.5 * dt) * in.v[i][c];
  Shell4FullShape middle, end;
  shape_of(x_mid, middle);
  cross_directors(middle, 1, in.r, p_corner);
  modes_of(in.v, v);
  modes_of(p_corner, p);
  modes_of(in.r, r);
  const EdgeShears edges = edge_shears(middle, v, p);
  Pack drilling[4];
  drilling_rates(middle, v, r, drilling);
  const Pack before = committed[Memory::at_thickness];
  ShellResultants sums[fibres];
  Pack normal_strain = broadcast(0.0), lost = broadcast(0.0);
  for (int k = 0; k < fibres; ++k) {
    ShellStrain strain;
    PlaneTurn turn;
    strain_at(Shell4Point(middle, k), v, p, edges, dt, strain, turn);
    follow_fibre(law, section, before, strain, turn, dt, memory.fibre(committed, k), memory.fibre(trial, k), sums[k]);
    normal_strain += 0.25 * sums[k].normal_strain;
    lost += 0.25 * sums[k].lost_in_bending;
  }
  const Pack thickness = section.thinning ? thinned(before, normal_strain) : before;
  trial[Memory::at_thickness] = thickness;

  shape_of(in.x, end);
  const ShellModuli moduli(law.lambda, law.mu);
  Pack f[4][3]{}, fp[4][3]{}, fp_corner[3][4], area = broadcast(0.0);
  EdgeShears edge_forces{};
  Largest largest;
  for (int k = 0; k < fibres; ++k) {
    const Shell4Point point(end, k);
    scale(sums[k], thickness);
    add_point(point, sums[k], f, fp, edge_forces);
    note(point, moduli, pack_sqrt(sums[k].stress2), largest);
    area += point.plane.J;
  }
  add_edge_forces(end, edge_forces, f, fp);
  const int at = memory.size();
  const Pack stiffness = drilling_stiffness(law.mu, thickness, 1.0 / area);
  Pack moment[4], m[4][3], m_corner[3][4], work = broadcast(0.0);
  resist_drilling(drilling, {1, 1, 1, 1}, area * thickness * stiffness, 1.0 - lost, dt, committed + at, trial + at,
                  work, moment);
  trial[at + 4] = committed[at + 4] + work;
  add_drilling(end, moment, f, m);
  to_corners(f, out.f);
  to_corners(fp, fp_corner);
  to_corners(m, m_corner);
  cross_directors(end, -1, fp_corner, out.m);
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 4; ++c) out.m[i][c] += m_corner[i][c];
  const double mean = section.offset, second = thickness_points(section).second + mean * mean;
  const Pack mass = committed[at_shell_mass], inertia = committed[at_rotary_inertia];
  const Pack over_both = 1.0 / (mass * inertia);
  const Pack omega2 =
      thickness * (over_both * inertia) *
      bound(end, largest, over_both * (mass * mass), thickness, second * thickness * thickness, area * stiffness);
  out.rate = stable_rate(omega2, broadcast(0.0));
  out.volume = thickness * select(end.least > 0.0, area, end.least * area);
}

}  // namespace brunt::element
