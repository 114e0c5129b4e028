// SPDX-License-Identifier: Apache-2.0
// The one-point hexahedron: mean gradient, midpoint strain increment, hourglass control, bulk viscosity and the stable
// step of the free element, for eight elements at once.
//
// D. P. Flanagan, T. Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679-706 (mean gradient B, hourglass control) and
// J. Appl. Mech. 51 (1984) 35-40 (eigenvalues of the uniform strain element). With S_ij = B_iI B_jI, corner mass m/8:
//   velocity gradient  L_ij = v_iI B_jI / V  at x_n - dt/2 v (second order, exact for rigid rotation)
//   hourglass shape    gamma_aI = Gamma_aI - (1/V) B_jI (x_jJ Gamma_aJ),  rates q_ia = v_iI gamma_aI
//   force              f_iI = -(s_ij B_jI + Q_ia gamma_aI)
//   frequency          omega^2 <= 8/(m V) [lambda tr S + 2 mu s_max] + 8/m k_hg (|gamma|^2 summed - 24):
// the bracket is the exact maximum over all strain modes when S is a multiple of the unit tensor (a cube).
#pragma once
#include <vector>

#include "brunt/element/batch.hpp"
#include "brunt/element/hex8_modes.hpp"
#include "brunt/element/objective.hpp"
#include "brunt/element/options.hpp"

namespace brunt::element {

template <class Response, HourglassKind hourglass>
struct Hex8 {
  static constexpr int nodes = 8;

  Response law;
  Hourglass control;
  BulkViscosity bulk;

  // history in this order; the mass is set once by the model
  static constexpr int at_mass = 0;
  static constexpr int at_stress = 1;
  static constexpr int at_tensors = at_stress + 6;
  static constexpr int at_scalars = at_tensors + 6 * Response::tensors;
  static constexpr int at_bulk_energy = at_scalars + Response::scalars;
  static constexpr int at_hourglass_energy = at_bulk_energy + 1;
  static constexpr int at_hourglass_force = at_hourglass_energy + (hourglass == HourglassKind::none ? 0 : 1);
  static constexpr int history_size = at_hourglass_force + (hourglass == HourglassKind::stiffness ? 12 : 0);

  static std::vector<HistoryField> history() {
    std::vector<HistoryField> fields{{"mass", 1}, {"stress", 6}};
    if (Response::tensors > 0) fields.push_back({"back_stress", 6 * Response::tensors});
    if (Response::scalars > 0) fields.push_back({"plastic_strain", Response::scalars});
    fields.push_back({"bulk_energy", 1});
    if (hourglass != HourglassKind::none) fields.push_back({"hourglass_energy", 1});
    if (hourglass == HourglassKind::stiffness) fields.push_back({"hourglass_force", 12});
    return fields;
  }

  void operator()(const BatchMotion<8>& in, Pack* history, BatchForce<8>& out) const;
};

namespace hex8_detail {

/// Modes of a nodal vector field: mode[m][component].
BRUNT_INLINE void vector_modes(const Pack (&u)[3][8], Pack (&mode)[hex_modes][3]) {
  for (int i = 0; i < 3; ++i) {
    Pack of_component[hex_modes];
    to_modes(u[i], of_component);
    for (int m = 0; m < hex_modes; ++m) mode[m][i] = of_component[m];
  }
}

/// G_ij = sum_m u_im g_jm * factor, row major.
BRUNT_INLINE void mean_gradient(const Pack (&u)[hex_modes][3], const Pack (&g)[6][3], Pack factor, Pack (&G)[9]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Pack sum = u[0][i] * g[0][j];
      for (int m = 1; m < 6; ++m) sum += u[m][i] * g[m][j];
      G[3 * i + j] = factor * sum;
    }
}

}  // namespace hex8_detail

template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::operator()(const BatchMotion<8>& in, Pack* history, BatchForce<8>& out) const {
  using namespace hex8_detail;
  const double dt = in.dt;
  Pack x[hex_modes][3], v[hex_modes][3];
  vector_modes(in.x, x);
  vector_modes(in.v, v);

  // the midpoint configuration: modes are linear in the coordinates
  Pack L[9], x_mid[hex_modes][3];
  {
    Pack g_mid[6][3];
    for (int m = 0; m < hex_modes; ++m)
      for (int i = 0; i < 3; ++i) x_mid[m][i] = x[m][i] - (0.5 * dt) * v[m][i];
    const Pack v_mid = gradient_modes(x_mid, g_mid);
    mean_gradient(v, g_mid, 1.0 / v_mid, L);
  }
  const StrainStep strain = strain_step(L, dt);

  Pack g[6][3];
  const Pack volume = gradient_modes(x, g);
  const Pack over_volume = 1.0 / volume;
  Pack lambda, mu;  // of the current tangent
  Pack* stress = history + at_stress;
  if constexpr (Response::hyperelastic) {
    Pack X[hex_modes][3], G[6][3], F[9], s[6];
    vector_modes(in.X, X);
    const Pack reference_volume = gradient_modes(X, G);
    mean_gradient(x, G, 1.0 / reference_volume, F);
    law.stress(F, s);
    law.tangent(F, lambda, mu);
    for (int c = 0; c < 6; ++c) stress[c] = s[c];
  } else {
    update_stress(law, strain, stress, history + at_tensors, history + at_scalars);
    Pack s[6];
    for (int c = 0; c < 6; ++c) s[c] = stress[c];
    law.tangent(s, lambda, mu);
  }

  // S = B B^T: lengths, frequency and hourglass stiffness all follow from it
  Pack S[6];
  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  for (int c = 0; c < 6; ++c) {
    Pack sum = g[0][row[c]] * g[0][column[c]];
    for (int m = 1; m < 6; ++m) sum += g[m][row[c]] * g[m][column[c]];
    S[c] = 8.0 * sum;
  }
  const Pack trace = S[0] + S[1] + S[2];
  const Pack largest = largest_eigenvalue_bound(S);
  const Pack mass = history[at_mass];

  // bulk viscosity, rho L^2 = mV/(2 s_max): L is the thickness of the element in its thinnest direction
  const Pack rate_of_volume = L[0] + L[4] + L[8];
  const Pack over_both = 1.0 / (mass * largest);  // one division for 1/mass and 1/s_max
  const Pack over_mass = largest * over_both;
  const Pack rho_length2 = 0.5 * mass * mass * volume * over_both;
  const Pack compression = select(rate_of_volume < 0.0, -rate_of_volume, broadcast(0.0));
  const Pack viscosity = bulk.linear * pack_sqrt((law.lambda + 2.0 * law.mu) * rho_length2) +
                         (bulk.quadratic * bulk.quadratic) * rho_length2 * compression;
  history[at_bulk_energy] += (dt * volume) * viscosity * rate_of_volume * rate_of_volume;

  const Pack frequency_factor = 8.0 * over_volume * over_mass;
  Pack omega2 = frequency_factor * (lambda * trace + 2.0 * mu * largest);
  const Pack damping = frequency_factor * trace * viscosity;

  // effective stress: material, viscous, and the part of the hourglass force that acts through B
  Pack sigma[9] = {stress[0] + viscosity * rate_of_volume, stress[3], stress[5], stress[3],
                   stress[1] + viscosity * rate_of_volume, stress[4], stress[5], stress[4],
                   stress[2] + viscosity * rate_of_volume};
  Pack force_mode[3][hex_modes];
  Pack hourglass_rate = broadcast(0.0);
  for (int i = 0; i < 3; ++i) force_mode[i][6] = broadcast(0.0);
  Pack Q[4][3];
  if constexpr (hourglass != HourglassKind::none) {
    Pack gamma2 = broadcast(8.0);  // sum over a of |gamma_a|^2, less 24: 8 for a parallelepiped
    for (int a = 0; a < 4; ++a) {
      const auto& h = x[3 + a];
      const Pack Sh[3] = {S[0] * h[0] + S[3] * h[1] + S[5] * h[2], S[3] * h[0] + S[1] * h[1] + S[4] * h[2],
                          S[5] * h[0] + S[4] * h[1] + S[2] * h[2]};
      Pack correction = over_volume * (h[0] * Sh[0] + h[1] * Sh[1] + h[2] * Sh[2]);
      if (a < 3) correction -= 16.0 * (h[0] * g[3 + a][0] + h[1] * g[3 + a][1] + h[2] * g[3 + a][2]);
      gamma2 += over_volume * correction;
    }
    gamma2 = pack_max(gamma2, broadcast(8.0));
    Pack stiffness = broadcast(0.0), viscous = broadcast(0.0);
    if constexpr (hourglass == HourglassKind::stiffness) {
      stiffness = (control.coefficient / 8.0 * law.mu) * trace * over_volume;
      omega2 += 8.0 * stiffness * gamma2 * over_mass;
    } else {  // J. O. Hallquist's form: coefficient/4 rho c V^(2/3), V^(2/3) = sqrt(2 s_max) for a cube
      viscous =
          (0.25 * control.coefficient) * pack_sqrt((law.lambda + 2.0 * law.mu) * mass * over_volume * 2.0 * largest);
      hourglass_rate = 4.0 * viscous * gamma2 * over_mass;
    }
    Pack work = broadcast(0.0);
    for (int a = 0; a < 4; ++a) {
      const auto& h = x_mid[3 + a];
      Pack q[3];
      for (int i = 0; i < 3; ++i) q[i] = v[3 + a][i] - (L[3 * i] * h[0] + L[3 * i + 1] * h[1] + L[3 * i + 2] * h[2]);
      if constexpr (hourglass == HourglassKind::stiffness) {
        Pack* stored = history + at_hourglass_force + 3 * a;
        Pack old[3] = {stored[0], stored[1], stored[2]};
        geometry::rotate_vector(strain.rotation, old[0], old[1], old[2]);
        for (int i = 0; i < 3; ++i) {
          Q[a][i] = old[i] + (stiffness * dt) * q[i];
          work += 0.5 * (old[i] + Q[a][i]) * q[i];
          stored[i] = Q[a][i];
        }
      } else {
        for (int i = 0; i < 3; ++i) {
          Q[a][i] = viscous * q[i];
          work += Q[a][i] * q[i];
        }
      }
    }
    history[at_hourglass_energy] += dt * work;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Pack sum = Q[0][i] * x[3][j];
        for (int a = 1; a < 4; ++a) sum += Q[a][i] * x[3 + a][j];
        sigma[3 * i + j] -= over_volume * sum;
      }
  }

  for (int i = 0; i < 3; ++i) {
    for (int m = 0; m < 6; ++m)
      force_mode[i][m] = -(sigma[3 * i] * g[m][0] + sigma[3 * i + 1] * g[m][1] + sigma[3 * i + 2] * g[m][2]);
    if constexpr (hourglass != HourglassKind::none)
      for (int a = 0; a < 4; ++a) force_mode[i][3 + a] -= Q[a][i];
    from_modes(force_mode[i], out.f[i]);
  }
  out.rate = pack_max(stable_rate(omega2, damping), hourglass_rate);
  out.volume = volume;
}

}  // namespace brunt::element
