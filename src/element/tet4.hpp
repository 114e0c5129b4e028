// SPDX-License-Identifier: Apache-2.0
// The four-node tetrahedron: constant gradient, so one point is full integration. Stiff (locks) in bending and in
// nearly incompressible flow; prefer hexahedra there.
//
// With B_I = V grad N_I and S = sum_I B_I B_I^T, corner mass m/4: f_I = -s B_I and, for the free element,
//   omega^2 <= 4/(m V) [lambda tr S + 2 mu s_max(S)].
#pragma once
#include <vector>

#include "element/batch.hpp"
#include "element/bulk_viscosity.hpp"
#include "element/logarithmic_rate.hpp"
#include "element/memory.hpp"
#include "element/objective.hpp"
#include "element/options.hpp"

namespace brunt::element {

template <class Response>
struct Tet4 {
  static constexpr int nodes = 4;

  Response law;
  BulkViscosity bulk;

  using Memory = SolidMemory<Response, 1>;
  static constexpr int history_size = Memory::size;

  [[nodiscard]] std::vector<HistoryField> history() const { return Memory::fields(law); }

  template <class Number>
  void operator()(const BatchMotion<4, Number>& in, const Pack* committed, Number* trial,
                  BatchForce<4, Number>& out) const;
};

namespace tet4_detail {

/// e[k][i] = u_(k+1),i - u_0,i
template <class Number>
BRUNT_INLINE void edges(const Number (&u)[3][4], Number (&e)[3][3]) {
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) e[k][i] = u[i][k + 1] - u[i][0];
}

/// B_k = V grad N_k of nodes 1, 2, 3 (that of node 0 is minus their sum) from the edges; returns the volume V.
template <class Number>
BRUNT_INLINE Number gradients(const Number (&e)[3][3], Number (&B)[3][3]) {
  for (int k = 0; k < 3; ++k) {
    const auto &a = e[(k + 1) % 3], &b = e[(k + 2) % 3];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      B[k][i] = (a[j] * b[l] - a[l] * b[j]) * (1.0 / 6.0);
    }
  }
  return e[0][0] * B[0][0] + e[0][1] * B[0][1] + e[0][2] * B[0][2];
}

/// du_i/dx_j (row major) of the field with edge differences u.
template <class Number, class Shape>
BRUNT_INLINE void gradient(const Number (&u)[3][3], const Shape (&B)[3][3], Shape volume, Number (&L)[9]) {
  const Shape over = 1.0 / volume;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) L[3 * i + j] = over * (u[0][i] * B[0][j] + u[1][i] * B[1][j] + u[2][i] * B[2][j]);
}

}  // namespace tet4_detail

template <class Response>
template <class Number>
void Tet4<Response>::operator()(const BatchMotion<4, Number>& in, const Pack* committed, Number* trial,
                                BatchForce<4, Number>& out) const {
  using namespace tet4_detail;
  Number x[3][3], v[3][3], x_mid[3][3], B[3][3], B_mid[3][3], L[9];
  edges(in.x, x);
  edges(in.v, v);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) x_mid[k][i] = x[k][i] - (0.5 * in.dt) * v[k][i];
  const Number volume_mid = gradients(x_mid, B_mid);
  gradient(v, B_mid, volume_mid, L);
  const Number volume = gradients(x, B);

  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  Number first[3], S[6];  // B of node 0
  for (int i = 0; i < 3; ++i) first[i] = -(B[0][i] + B[1][i] + B[2][i]);
  for (int c = 0; c < 6; ++c) {
    S[c] = first[row[c]] * first[column[c]];
    for (int k = 0; k < 3; ++k) S[c] += B[k][row[c]] * B[k][column[c]];
  }
  const Number trace = S[0] + S[1] + S[2], largest = largest_eigenvalue_bound(S);
  const Pack mass = committed[Memory::at_mass];
  const Number volume_rate = L[0] + L[4] + L[8];
  const Number viscosity =
      bulk_viscosity(bulk, wave_modulus(law, Memory::point(committed)), mass * volume / largest, volume_rate);
  [[maybe_unused]] const Number viscous_work =
      book_bulk_work(committed + Memory::at_bulk_energy, trial + Memory::at_bulk_energy, viscosity * volume_rate,
                     volume, volume_rate, in.dt);

  Number s[6];
  [[maybe_unused]] Pack lambda, mu;
  if constexpr (Response::hyperelastic) {
    Pack X[3][3], B_reference[3][3];
    Number F[9];
    edges(in.X, X);
    const Pack reference_volume = gradients(X, B_reference);
    gradient(x, B_reference, reference_volume, F);
    law.stress(F, s);
    if constexpr (bounds_step<Number>) law.tangent(F, lambda, mu);
    for (int c = 0; c < 6; ++c) trial[Memory::at_stress + c] = s[c];
  } else {
    const PointMemory<const Pack> before = Memory::point(committed);
    const PointMemory<Number> after = Memory::point(trial);
    const StrainStep<Number> strain = strain_step_of<Response>(L, in.dt, before, after);
    if constexpr (Thermodynamic<Response>) {
      const Pack over_reference = law.density / mass;
      update_stress(law, strain, {in.dt, volume * over_reference, viscous_work * over_reference}, before, after, s,
                    lambda, mu);
    } else {
      update_stress(law, strain, before, after, s);
      if constexpr (bounds_step<Number>) law.tangent(s, lambda, mu);
    }
  }

  for (int i = 0; i < 3; ++i) s[i] += viscosity * volume_rate;
  const Number full[9] = {s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2]};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      out.f[i][k + 1] = -(full[3 * i] * B[k][0] + full[3 * i + 1] * B[k][1] + full[3 * i + 2] * B[k][2]);
    out.f[i][0] = -(out.f[i][1] + out.f[i][2] + out.f[i][3]);
  }

  if constexpr (bounds_step<Number>) {
    const Pack factor = 4.0 / (mass * volume);
    out.rate = stable_rate(factor * (pack_max(lambda, broadcast(0.0)) * trace + 2.0 * mu * largest),
                           factor * trace * viscosity);
    out.volume = volume;
    out.stiffness = {lambda, mu, viscosity, broadcast(0.0), broadcast(0.0), factor * ((lambda + 2.0 * mu) * largest)};
  }
}

}  // namespace brunt::element
