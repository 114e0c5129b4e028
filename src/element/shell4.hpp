// SPDX-License-Identifier: Apache-2.0
// The one-point quadrilateral of a shell with hourglass control, for a batch of elements at once.
//
// T. Belytschko, J. I. Lin, C. S. Tsay, Comput. Methods Appl. Mech. Eng. 42 (1984) 225 (axes that turn with the
// element, one point, hourglass control); T. Belytschko, B. L. Wong, H. Y. Chiang, the same 96 (1992) 93 (fibres of the
// warped surface). Strains, the transverse shears of the edges and the hourglass modes: shell4_shape.hpp; stresses
// through the thickness: shell_layers.hpp; stable step: shell4_step.hpp. Strains are those of the midpoint
// configuration, forces those of the end of the step.
#pragma once
#include <cmath>
#include <vector>

#include "element/batch.hpp"
#include "element/options.hpp"
#include "element/shell4_shape.hpp"
#include "element/shell4_step.hpp"
#include "element/shell_batch.hpp"
#include "element/shell_drilling.hpp"
#include "element/shell_layers.hpp"

namespace brunt::element {

template <class Response>
struct Shell4 {
  static constexpr int nodes = 4, fibres = 1;
  using Memory = ShellMemory<Response, 1>;
  static constexpr int hourglass_forces = 6;  ///< two of the membrane, two of bending, two of shears
  static constexpr int most_history = Memory::most + hourglass_forces + 5;

  Response law;
  ShellSection section;
  Hourglass control;

  [[nodiscard]] std::vector<HistoryField> history() const {
    std::vector<HistoryField> fields = Memory(section).fields(law, section.thickness);
    if (control.kind != HourglassKind::none) fields.push_back({"hourglass_force", hourglass_forces});
    fields.push_back({"drilling_moment", 4});
    fields.push_back({"hourglass_energy", 1});
    return fields;
  }

  void operator()(const ShellMotion<4>& in, const Pack* committed, Pack* trial, ShellForce<4>& out) const;

 private:
  /// Of a step: strain rates, turn of the stresses, resultants at its end.
  struct Step {
    Shell4Rates rates;
    PlaneTurn turn;
    ShellResultants sum;
  };
  BRUNT_INLINE void strain(const ShellMotion<4>& in, const Pack (&x)[4][3], const Pack* committed, Pack* trial,
                           Step& step) const;
  BRUNT_INLINE Pack resist_hourglass(const Step& step, Pack middle, Pack volume, double dt, const Pack* committed,
                                     Pack* trial, Shell4Springs& springs, Shell4Stress& stress) const;
};

namespace shell4_detail {

/// Modes of a field on the corners, [mode][component].
BRUNT_INLINE void modes_of(const Pack (&u)[3][4], Pack (&mode)[4][3]) {
  for (int i = 0; i < 3; ++i) {
    Pack of_component[4];
    to_quad_modes(u[i], of_component);
    for (int m = 0; m < 4; ++m) mode[m][i] = of_component[m];
  }
}

/// In other axes, [component][mode].
BRUNT_INLINE void modes_in(const ShellAxes& axes, const Pack (&mode)[4][3], Pack (&local)[3][4]) {
  for (int m = 0; m < 4; ++m) {
    Pack of_mode[3];
    axes.to_local(mode[m], of_mode);
    for (int i = 0; i < 3; ++i) local[i][m] = of_mode[i];
  }
}

/// Minus the forces on the modes in these axes, on the corners in space.
BRUNT_INLINE void to_corners(const ShellAxes& axes, const Pack (&local)[3][4], Pack (&corner)[3][4]) {
  Pack mode[3][4];
  for (int m = 0; m < 4; ++m) {
    const Pack of_mode[3] = {-local[0][m], -local[1][m], -local[2][m]};
    Pack global[3];
    axes.to_global(of_mode, global);
    for (int i = 0; i < 3; ++i) mode[i][m] = global[i];
  }
  for (int i = 0; i < 3; ++i) from_quad_modes(mode[i], corner[i]);
}

/// The strain increment of a step.
BRUNT_INLINE ShellStrain strain_of(const Shell4Rates& rates, double dt) {
  ShellStrain strain;
  strain.membrane[0] = dt * rates.L[0][0];
  strain.membrane[1] = dt * rates.L[1][1];
  strain.membrane[2] = (0.5 * dt) * (rates.L[0][1] + rates.L[1][0]);
  for (int c = 0; c < 3; ++c) strain.curvature[c] = dt * rates.curvature[c];
  for (int c = 0; c < 2; ++c) strain.shear[c] = (0.5 * dt) * rates.shear[c];
  return strain;
}

}  // namespace shell4_detail

/// Hourglass forces at the end of the step. Springs of membrane and bending turn with the stresses: half of the rate is
/// applied before, half after; those of the shears belong to xi and eta. `middle`: height of the middle over the
/// reference surface, whose membrane mode the springs see. `springs` become the dashpots of viscous control, the
/// coefficient times the critical damping of each mode with its spring in full, over A h. Returns the work of the step.
template <class Response>
Pack Shell4<Response>::resist_hourglass(const Step& step, Pack middle, Pack volume, double dt, const Pack* committed,
                                        Pack* trial, Shell4Springs& springs, Shell4Stress& stress) const {
  const int at = Memory(section).size();
  const auto& [rates, turn, sum] = step;
  const Pack q[hourglass_forces] = {rates.of_membrane[0] + middle * rates.of_bending[0],
                                    rates.of_membrane[1] + middle * rates.of_bending[1],
                                    rates.of_bending[0],
                                    rates.of_bending[1],
                                    rates.linear_shear[0],
                                    rates.linear_shear[1]};
  Pack* const coefficient[hourglass_forces] = {&springs.membrane, &springs.membrane, &springs.bending,
                                               &springs.bending,  &springs.shear[0], &springs.shear[1]};
  Pack Q[hourglass_forces], work = broadcast(0.0);
  if (control.kind == HourglassKind::viscous) {
    const Pack density = control.coefficient * committed[at_shell_mass] / volume;
    springs.membrane = pack_sqrt(springs.membrane * density);
    springs.bending = pack_sqrt(springs.bending * density * committed[at_rotary_inertia] / committed[at_shell_mass]);
    for (Pack& shear : springs.shear) shear = pack_sqrt(shear * density);
    for (int c = 0; c < hourglass_forces; ++c) Q[c] = volume * *coefficient[c] * q[c];
  } else {
    const bool flows = control.kind == HourglassKind::stiffness;
    const Pack one = broadcast(1.0), left = flows ? one - sum.lost : one;
    const Pack left_in_bending = flows ? one - sum.lost_in_bending : one;
    Pack half[hourglass_forces];
    for (int c = 0; c < hourglass_forces; ++c) {
      half[c] = (0.5 * dt) * volume * *coefficient[c] * q[c];
      Q[c] = committed[at + c] + half[c];
    }
    turn_vector(turn, Q[0], Q[1]);
    turn_vector(turn, Q[2], Q[3]);
    for (int c = 0; c < hourglass_forces; ++c) Q[c] = (c == 2 || c == 3 ? left_in_bending : left) * (Q[c] + half[c]);
  }
  for (int c = 0; c < hourglass_forces; ++c) {
    work += 0.5 * (committed[at + c] + Q[c]) * q[c];
    trial[at + c] = Q[c];
  }
  for (int i = 0; i < 2; ++i) {
    stress.of_membrane[i] = Q[i];
    stress.of_bending[i] = Q[2 + i] + middle * Q[i];
    stress.linear_shear[i] = Q[4 + i];
  }
  return dt * work;
}

/// Strains in the midpoint configuration, stresses and thickness at the end of the step.
template <class Response>
void Shell4<Response>::strain(const ShellMotion<4>& in, const Pack (&x)[4][3], const Pack* committed, Pack* trial,
                              Step& step) const {
  using namespace shell4_detail;
  const Memory memory(section);
  const double dt = in.dt;
  Pack v[4][3], r[4][3], x_mid[4][3], v_mid[3][4], r_mid[3][4];
  modes_of(in.v, v);
  modes_of(in.r, r);
  for (int m = 1; m < 4; ++m)
    for (int i = 0; i < 3; ++i) x_mid[m][i] = x[m][i] - (0.5 * dt) * v[m][i];
  const Shell4Shape middle(x_mid, section.warping);
  modes_in(middle.plane.axes, v, v_mid);
  modes_in(middle.plane.axes, r, r_mid);
  shell4_rates(middle, v_mid, r_mid, step.rates);
  step.turn = plane_turn(dt * step.rates.spin, middle.plane.length, dt * (v_mid[0][1] + v_mid[1][2]),
                         dt * (v_mid[1][1] - v_mid[0][2]));
  ShellStrain strain = strain_of(step.rates, dt);
  strain.see_from_end(step.turn);
  const Pack thickness = committed[Memory::at_thickness];
  follow_fibre(law, section, thickness, strain, step.turn, dt, memory.fibre(committed), memory.fibre(trial), step.sum);
  trial[Memory::at_thickness] = section.thinning ? thinned(thickness, step.sum.normal_strain) : thickness;
}

template <class Response>
void Shell4<Response>::operator()(const ShellMotion<4>& in, const Pack* committed, Pack* trial,
                                  ShellForce<4>& out) const {
  using namespace shell4_detail;
  Pack x[4][3];
  modes_of(in.x, x);
  Step step;
  strain(in, x, committed, trial, step);
  const Pack thickness = trial[Memory::at_thickness];
  ShellResultants& sum = step.sum;
  scale(sum, thickness);

  const Shell4Shape end(x, section.warping);
  const ThicknessPoints& rule = thickness_points(section);
  const ShellModuli moduli(law.lambda, law.mu);
  const Pack area = 4.0 * end.plane.J, volume = area * thickness, height2 = thickness * thickness;
  const Pack mass = committed[at_shell_mass], inertia = committed[at_rotary_inertia];
  const Pack over_both = 1.0 / (mass * inertia), over_mass = over_both * inertia;
  Shell4Bounds bounds;
  end.plane.metric(bounds.largest, bounds.trace);
  bounds.over_inertia = over_both * (mass * mass);
  bounds.drilling = drilling_stiffness(law.mu, thickness, 0.25 * end.plane.over_J);
  bounds.moment = rule.second * height2;
  bounds.mean = std::abs(section.offset) * thickness;
  bounds.square = bounds.moment + bounds.mean * bounds.mean;
  bounds.radius = std::sqrt(rule.second + section.offset * section.offset) * thickness;
  bounds.stress = pack_sqrt(sum.stress2);

  Shell4Stress stress;
  for (int c = 0; c < 3; ++c) {
    stress.membrane[c] = area * sum.force[c];
    stress.moment[c] = area * sum.moment[c];
  }
  for (int c = 0; c < 2; ++c) {
    stress.shear[c] = area * sum.shear[c];
    stress.linear_shear[c] = stress.of_membrane[c] = stress.of_bending[c] = broadcast(0.0);
  }
  Shell4Springs springs = shell4_springs(end, moduli, control.coefficient, bounds.trace, bounds.moment);
  const Shell4Springs none{broadcast(0.0), broadcast(0.0), {broadcast(0.0), broadcast(0.0)}};
  Pack damping = broadcast(0.0), work = broadcast(0.0);
  if (control.kind == HourglassKind::none)
    springs = none;
  else
    work = resist_hourglass(step, section.offset * thickness, volume, in.dt, committed, trial, springs, stress);
  const int at = Memory(section).size() + (control.kind == HourglassKind::none ? 0 : hourglass_forces);
  resist_drilling(step.rates.drilling, {1, 1, 1, 1}, volume * bounds.drilling, 1.0 - sum.lost_in_bending, in.dt,
                  committed + at, trial + at, work, stress.drilling);
  trial[at + 4] = committed[at + 4] + work;
  if (control.kind == HourglassKind::viscous) {
    const auto [modes, linear] = shell4_hourglass(end, springs, bounds);
    damping = volume * over_mass * (modes * (1.0 + hourglass_share(end, bounds)) + linear);
    springs = none;
  }
  Pack f[3][4], m[3][4];
  shell4_forces(end, stress, f, m);
  to_corners(end.plane.axes, f, out.f);
  to_corners(end.plane.axes, m, out.m);
  out.rate =
      stable_rate(volume * over_mass * shell4_frequency(end, moduli, springs, bounds, section.offset != 0), damping);
  // Jacobians of the middles of the edges: where one is not positive, the quadrilateral crosses itself.
  const Pack along_xi = pack_abs(end.plane.ax * end.h[1] - end.plane.c * end.h[0]);
  const Pack along_eta = pack_abs(end.plane.by * end.h[0] - end.plane.c * end.h[1]);
  const Pack least = end.plane.J - pack_max(along_xi, along_eta);
  out.volume = select(least > 0.0, volume, least * thickness);
}

}  // namespace brunt::element
