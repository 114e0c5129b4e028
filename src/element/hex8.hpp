// SPDX-License-Identifier: Apache-2.0
// The one-point hexahedron: mean gradient, midpoint strain increment, hourglass control, bulk viscosity and the stable
// step of the free element, for a batch of elements at once.
//
// D. P. Flanagan, T. Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679-706 (mean gradient B, hourglass control) and
// J. Appl. Mech. 51 (1984) 35-40 (eigenvalues of the uniform strain element). With S_ij = B_iI B_jI, corner mass m/8:
//   velocity gradient  L_ij = v_iI B_jI / V  at x_n - dt/2 v (second order, exact for rigid rotation)
//   hourglass shape    gamma_aI = Gamma_aI - (1/V) B_jI (x_jJ Gamma_aJ),  rates q_ia = v_iI gamma_aI
//   force              f_iI = -(s_ij B_jI + Q_ia gamma_aI)
//   hourglass forces   Q <- beta R (Q + k q dt), beta the share of the trial deviator that radial return leaves: Q
//     stands for what stresses within the element deviate from their mean, which flow limits with it (without flow, and
//     where the control is `elastic`, beta = 1);
//     viscous control: Q = c q. Their work over a step is dt q . (Q before + Q after)/2, as nodes take it from them: a
//     viscous force of t_n acts on v_{n+1/2} too, and the product c q^2 dt is more than it takes
//   frequency          omega^2 <= 8/(m V) [lambda tr S + 2 mu s_max] + 8/m k_hg (|gamma|^2 summed - 24):
// the bracket is the exact maximum over all strain modes when S is a multiple of the unit tensor (a cube).
//
// Hyperelastic laws: the force is the derivative of a potential of the positions, so that a closed path of deformation
// returns all of its work. With the mean gradient B0, the volume V0 and the hourglass coordinates H_ja = X_jI Gamma_aI
// of the reference shape (total Lagrangian form: G. R. Joldes, A. Wittek, K. Miller, Commun. Numer. Meth. Eng. 24
// (2008) 1315-1323):
//   strain     F_ij = x_iI B0_jI / V0, energy V0 psi(F); its force is -s_ij B_jI with B = cof(F) B0 and V = V0 det F
//   hourglass  q_ia = x_iI gamma0_aI = h_ia - F_ij H_ja, energy k0/2 sum q^2, k0 and gamma0 of the reference shape:
//              zero for every homogeneous deformation, and unchanged by rotation, since |q_a| is. Its force is
//              -k0 q_ia gamma0_aI = -k0 q_ia (Gamma_aI - (F H)_ja B_jI / V)
//   frequency  as above with these B, V, k0 and gamma0 (a prestress has no part in the hourglass modes, as F has none)
#pragma once
#include <vector>

#include "element/batch.hpp"
#include "element/bulk_viscosity.hpp"
#include "element/hex8_modes.hpp"
#include "element/hex8_point.hpp"
#include "element/logarithmic_rate.hpp"
#include "element/memory.hpp"
#include "element/objective.hpp"
#include "element/options.hpp"

namespace brunt::element {

template <class Response, HourglassKind hourglass>
struct Hex8 {
  static constexpr int nodes = 8;

  Response law;
  Hourglass control;
  BulkViscosity bulk;

  using Memory = SolidMemory<Response, 1>;
  static constexpr int at_hourglass_energy = Memory::size;
  static constexpr int at_hourglass_force = at_hourglass_energy + (hourglass == HourglassKind::none ? 0 : 1);
  static constexpr bool from_potential = Response::hyperelastic && hourglass == HourglassKind::stiffness;
  static constexpr bool remembers_force = hourglass != HourglassKind::none && !from_potential;
  static constexpr int history_size = at_hourglass_force + (remembers_force ? 12 : 0);

  [[nodiscard]] std::vector<HistoryField> history() const {
    std::vector<HistoryField> fields = Memory::fields(law);
    if (hourglass != HourglassKind::none) fields.push_back({"hourglass_energy", 1});
    if (remembers_force) fields.push_back({"hourglass_force", 12});
    return fields;
  }

  void operator()(const BatchMotion<8>& in, const Pack* committed, Pack* trial, BatchForce<8>& out) const;

 private:
  /// Modes of positions and velocities, gradients at the end of the step, and the velocity gradient at the midpoint.
  struct Kinematics {
    Pack x[hex_modes][3], v[hex_modes][3], h_mid[4][3];  // h_mid: hourglass modes of the midpoint configuration
    Pack g[6][3], L[9], S[6];
    Pack volume, over_volume;
    StrainStep<Pack> strain;  // of rate laws
    // of hyperelastic laws: deformation gradient; hourglass coordinates of the reference shape, moved by it; stiffness
    // of the hourglass springs; hourglass_norm of the reference shape
    Pack F[9], moved[4][3], stiffness, gamma2;
  };
  /// Of the stress update: data for the stable step, and the share of the trial deviator that remains after plastic
  /// flow.
  struct Tangent {
    Pack lambda, mu;
    Pack left = broadcast(1.0);
  };
  /// Bulk viscosity, which some laws need before their stress, and its intermediate values.
  struct Viscous {
    Pack viscosity, stress, work;
    Pack largest, over_mass;  ///< bound of the eigenvalues of S
  };
  /// Forces that act through B as a stress (row major) and through the hourglass shapes, and bounds of the step.
  struct Resistance {
    Pack stress[9], Q[4][3];
    Pack omega2, damping;
    Pack hourglass_rate = broadcast(0.0);
    Pack spring = broadcast(0.0), dashpot = broadcast(0.0), plane2;
  };

  BRUNT_INLINE void move(const BatchMotion<8>& in, Kinematics& k) const;
  BRUNT_INLINE void move_from_reference(const BatchMotion<8>& in, Kinematics& k) const;
  BRUNT_INLINE Viscous damp(const Kinematics& k, double dt, const Pack* committed, Pack* trial) const;
  BRUNT_INLINE Tangent update(const Kinematics& k, const Viscous& viscous, double dt, const Pack* committed,
                              Pack* trial, Pack (&s)[6]) const;
  BRUNT_INLINE void resist(const Kinematics& k, const Viscous& viscous, const Tangent& tangent, const Pack (&s)[6],
                           double dt, const Pack* committed, Pack* trial, Resistance& r) const;
  BRUNT_INLINE void resist_hourglass(const Kinematics& k, [[maybe_unused]] Pack left, double dt, Pack over_mass,
                                     Pack mass, Pack trace, Pack largest, const Pack* committed, Pack* trial,
                                     Resistance& r) const;
  BRUNT_INLINE void resist_from_potential(const Kinematics& k, Pack over_mass, Pack* trial, Resistance& r) const;
  BRUNT_INLINE void add_hourglass_stress(const Pack (&Q)[4][3], const Pack (*h)[3], Pack over_volume,
                                         Pack (&stress)[9]) const;
};

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

/// T y for T = (xx, yy, zz, xy, yz, zx).
BRUNT_INLINE void times(const Pack (&T)[6], const Pack (&y)[3], Pack (&result)[3]) {
  result[0] = T[0] * y[0] + T[3] * y[1] + T[5] * y[2];
  result[1] = T[3] * y[0] + T[1] * y[1] + T[4] * y[2];
  result[2] = T[5] * y[0] + T[4] * y[1] + T[2] * y[2];
}

BRUNT_INLINE Pack dot(const Pack (&a)[3], const Pack (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Sum over a of |gamma_a|^2, less 24: 8 for a parallelepiped. x: modes of the coordinates.
BRUNT_INLINE Pack hourglass_norm(const Pack (&x)[hex_modes][3], const Pack (&g)[6][3], const Pack (&S)[6],
                                 Pack over_volume) {
  Pack gamma2 = broadcast(8.0);
  for (int a = 0; a < 4; ++a) {
    const auto& h = x[3 + a];
    Pack Sh[3];
    times(S, h, Sh);
    Pack correction = over_volume * dot(h, Sh);
    if (a < 3) correction -= 16.0 * dot(h, g[3 + a]);
    gamma2 += over_volume * correction;
  }
  return pack_max(gamma2, broadcast(8.0));
}

template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::move(const BatchMotion<8>& in, Kinematics& k) const {
  vector_modes(in.x, k.x);
  vector_modes(in.v, k.v);
  Pack x_mid[hex_modes][3], g_mid[6][3];  // modes are linear in the coordinates: no second gather
  for (int m = 0; m < hex_modes; ++m)
    for (int i = 0; i < 3; ++i) x_mid[m][i] = k.x[m][i] - (0.5 * in.dt) * k.v[m][i];
  const Pack volume_mid = gradient_modes(x_mid, g_mid);
  mean_gradient(k.v, g_mid, 1.0 / volume_mid, k.L);
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 3; ++i) k.h_mid[a][i] = x_mid[3 + a][i];
  k.volume = gradient_modes(k.x, k.g);
  k.over_volume = 1.0 / k.volume;
  gradient_gram(k.g, k.S);
}

template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::move_from_reference(const BatchMotion<8>& in, Kinematics& k) const {
  Pack X[hex_modes][3], G[6][3], rate[9], F_mid[9], cofactor[9];
  vector_modes(in.X, X);
  vector_modes(in.x, k.x);
  vector_modes(in.v, k.v);
  const Pack reference_volume = gradient_modes(X, G);
  const Pack over_reference = 1.0 / reference_volume;
  mean_gradient(k.x, G, over_reference, k.F);
  mean_gradient(k.v, G, over_reference, rate);
  for (int c = 0; c < 9; ++c) F_mid[c] = k.F[c] - (0.5 * in.dt) * rate[c];
  space_gradient(rate, F_mid, k.L);
  k.volume = reference_volume * cofactors(k.F, cofactor);
  k.over_volume = 1.0 / k.volume;
  for (int m = 0; m < 6; ++m)
    for (int i = 0; i < 3; ++i)
      k.g[m][i] = cofactor[3 * i] * G[m][0] + cofactor[3 * i + 1] * G[m][1] + cofactor[3 * i + 2] * G[m][2];
  gradient_gram(k.g, k.S);
  if constexpr (from_potential) {
    Pack S[6];
    gradient_gram(G, S);
    k.stiffness = (control.coefficient / 8.0 * law.mu) * (S[0] + S[1] + S[2]) * over_reference;
    k.gamma2 = hourglass_norm(X, G, S, over_reference);
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i)
        k.moved[a][i] = k.F[3 * i] * X[3 + a][0] + k.F[3 * i + 1] * X[3 + a][1] + k.F[3 * i + 2] * X[3 + a][2];
  } else {
    for (int a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i) k.h_mid[a][i] = k.x[3 + a][i] - (0.5 * in.dt) * k.v[3 + a][i];
  }
}

template <class Response, HourglassKind hourglass>
typename Hex8<Response, hourglass>::Tangent Hex8<Response, hourglass>::update(const Kinematics& k,
                                                                              const Viscous& viscous, double dt,
                                                                              const Pack* committed, Pack* trial,
                                                                              Pack (&s)[6]) const {
  Tangent tangent;
  if constexpr (Response::hyperelastic) {
    law.stress(k.F, s);
    law.tangent(k.F, tangent.lambda, tangent.mu);
    for (int c = 0; c < 6; ++c) trial[Memory::at_stress + c] = s[c];
  } else if constexpr (Thermodynamic<Response>) {
    const Pack over_reference = law.density / committed[Memory::at_mass];
    tangent.left = update_stress(law, k.strain, {dt, k.volume * over_reference, viscous.work * over_reference},
                                 Memory::point(committed), Memory::point(trial), s, tangent.lambda, tangent.mu);
  } else {
    tangent.left = update_stress(law, k.strain, Memory::point(committed), Memory::point(trial), s);
    law.tangent(s, tangent.lambda, tangent.mu);
  }
  return tangent;
}

/// rho L^2 = m V / (2 s_max): L is the thickness of the element in its thinnest direction.
template <class Response, HourglassKind hourglass>
typename Hex8<Response, hourglass>::Viscous Hex8<Response, hourglass>::damp(const Kinematics& k, double dt,
                                                                            const Pack* committed, Pack* trial) const {
  const Pack mass = committed[Memory::at_mass], volume_rate = k.L[0] + k.L[4] + k.L[8];
  Viscous viscous;
  viscous.largest = largest_eigenvalue_bound(k.S);
  const Pack over_both = 1.0 / (mass * viscous.largest);  // one division for 1/mass and 1/s_max
  viscous.over_mass = viscous.largest * over_both;
  const Pack rho_length2 = 0.5 * mass * mass * k.volume * over_both;
  viscous.viscosity = bulk_viscosity(bulk, wave_modulus(law, Memory::point(committed)), rho_length2, volume_rate);
  viscous.stress = viscous.viscosity * volume_rate;
  viscous.work = book_bulk_work(committed + Memory::at_bulk_energy, trial + Memory::at_bulk_energy, viscous.stress,
                                k.volume, volume_rate, dt);
  return viscous;
}

template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::resist(const Kinematics& k, const Viscous& viscous, const Tangent& tangent,
                                       const Pack (&s)[6], double dt, const Pack* committed, Pack* trial,
                                       Resistance& r) const {
  const Pack trace = k.S[0] + k.S[1] + k.S[2];
  const Pack largest = viscous.largest, over_mass = viscous.over_mass;
  const Pack mass = committed[Memory::at_mass];
  const Pack frequency_factor = 8.0 * k.over_volume * over_mass;
  // a negative lambda lowers no mode that has no volume change
  const Pack lambda = pack_max(tangent.lambda, broadcast(0.0));
  r.omega2 = frequency_factor * (lambda * trace + 2.0 * tangent.mu * largest);
  r.damping = frequency_factor * trace * viscous.viscosity;
  r.plane2 = frequency_factor * ((lambda + 2.0 * tangent.mu) * largest);
  constexpr int place[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};
  for (int c = 0; c < 9; ++c) r.stress[c] = s[place[c]];
  for (int c = 0; c < 9; c += 4) r.stress[c] += viscous.stress;
  if constexpr (from_potential)
    resist_from_potential(k, over_mass, trial, r);
  else if constexpr (hourglass != HourglassKind::none)
    resist_hourglass(k, control.kind == HourglassKind::elastic ? broadcast(1.0) : tangent.left, dt, over_mass, mass,
                     trace, largest, committed, trial, r);
}

template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::resist_hourglass(const Kinematics& k, [[maybe_unused]] Pack left, double dt,
                                                 Pack over_mass, Pack mass, Pack trace, Pack largest,
                                                 const Pack* committed, Pack* trial, Resistance& r) const {
  const Pack gamma2 = hourglass_norm(k.x, k.g, k.S, k.over_volume);
  [[maybe_unused]] Pack stiffness, viscous;
  if constexpr (hourglass == HourglassKind::stiffness) {
    stiffness = (control.coefficient / 8.0 * law.mu) * trace * k.over_volume;
    r.omega2 += 8.0 * stiffness * gamma2 * over_mass;
    r.spring = stiffness;
  } else {  // J. O. Hallquist's form: coefficient/4 rho c V^(2/3), V^(2/3) = sqrt(2 s_max) for a cube
    viscous =
        (0.25 * control.coefficient) * pack_sqrt((law.lambda + 2.0 * law.mu) * mass * k.over_volume * 2.0 * largest);
    r.hourglass_rate = 4.0 * viscous * gamma2 * over_mass;
    r.dashpot = viscous;
  }

  Pack work = broadcast(0.0);
  for (int a = 0; a < 4; ++a) {
    const auto& h = k.h_mid[a];
    const Pack* before = committed + at_hourglass_force + 3 * a;
    Pack* after = trial + at_hourglass_force + 3 * a;
    for (int i = 0; i < 3; ++i)
      r.Q[a][i] = k.v[3 + a][i] - (k.L[3 * i] * h[0] + k.L[3 * i + 1] * h[1] + k.L[3 * i + 2] * h[2]);
    Pack(&Q)[3] = r.Q[a];
    if constexpr (hourglass == HourglassKind::stiffness) {
      // q refers to the midpoint: (1 + R)/2 rotates it by exactly half of the step's rotation, as R rotates the stored
      // force. Without this rotation, the rotation of a body would feed energy into hourglass modes.
      Pack turned[3], q[3];
      for (int i = 0; i < 3; ++i) {
        q[i] = Q[i];
        turned[i] = before[i] + (0.5 * stiffness * dt) * q[i];
      }
      geometry::rotate_vector(k.strain.rotation, turned[0], turned[1], turned[2]);
      for (int i = 0; i < 3; ++i) {
        Q[i] = left * (turned[i] + (0.5 * stiffness * dt) * q[i]);
        work += 0.5 * (before[i] + Q[i]) * q[i];
        after[i] = Q[i];
      }
    } else {
      for (int i = 0; i < 3; ++i) {
        const Pack now = viscous * Q[i];
        work += 0.5 * (before[i] + now) * Q[i];
        after[i] = Q[i] = now;
      }
    }
  }
  trial[at_hourglass_energy] = committed[at_hourglass_energy] + dt * work;

  add_hourglass_stress(r.Q, k.x + 3, k.over_volume, r.stress);
}

template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::resist_from_potential(const Kinematics& k, Pack over_mass, Pack* trial,
                                                      Resistance& r) const {
  r.omega2 += 8.0 * k.stiffness * k.gamma2 * over_mass;
  r.spring = k.stiffness;
  Pack squares = broadcast(0.0);
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 3; ++i) {
      const Pack q = k.x[3 + a][i] - k.moved[a][i];
      squares += q * q;
      r.Q[a][i] = k.stiffness * q;
    }
  trial[at_hourglass_energy] = 0.5 * k.stiffness * squares;
  add_hourglass_stress(r.Q, k.moved, k.over_volume, r.stress);
}

/// gamma has a part along B, which acts like a stress. h: hourglass coordinates that gamma does not contain.
template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::add_hourglass_stress(const Pack (&Q)[4][3], const Pack (*h)[3], Pack over_volume,
                                                     Pack (&stress)[9]) const {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Pack sum = Q[0][i] * h[0][j];
      for (int a = 1; a < 4; ++a) sum += Q[a][i] * h[a][j];
      stress[3 * i + j] -= over_volume * sum;
    }
}

template <class Response, HourglassKind hourglass>
void Hex8<Response, hourglass>::operator()(const BatchMotion<8>& in, const Pack* committed, Pack* trial,
                                           BatchForce<8>& out) const {
  Kinematics k;
  Resistance r;
  if constexpr (Response::hyperelastic)
    move_from_reference(in, k);
  else {
    move(in, k);
    k.strain = strain_step_of<Response>(k.L, in.dt, Memory::point(committed), Memory::point(trial));
  }
  Pack s[6];
  const Viscous viscous = damp(k, in.dt, committed, trial);
  const Tangent tangent = update(k, viscous, in.dt, committed, trial, s);
  resist(k, viscous, tangent, s, in.dt, committed, trial, r);
  for (int i = 0; i < 3; ++i) {
    Pack force[hex_modes];
    for (int m = 0; m < 6; ++m)
      force[m] = -(r.stress[3 * i] * k.g[m][0] + r.stress[3 * i + 1] * k.g[m][1] + r.stress[3 * i + 2] * k.g[m][2]);
    force[6] = broadcast(0.0);
    if constexpr (hourglass != HourglassKind::none)
      for (int a = 0; a < 4; ++a) force[3 + a] -= r.Q[a][i];
    from_modes(force, out.f[i]);
  }
  out.rate = pack_max(stable_rate(r.omega2, r.damping), r.hourglass_rate);
  out.volume = k.volume;
  out.stiffness = {tangent.lambda, tangent.mu, viscous.viscosity, r.spring, r.dashpot, r.plane2};
}

}  // namespace brunt::element
