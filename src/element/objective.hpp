// SPDX-License-Identifier: Apache-2.0
// The objective stress update of one integration point, of second order in the step.
#pragma once
#include <algorithm>

#include "core/simd.hpp"
#include "element/memory.hpp"
#include "geometry/rotation.hpp"

namespace brunt::element {

/// Strain and rotation of a step, both with respect to its end.
template <class Number>
struct StrainStep {
  Number strain[6];    ///< increment, tensor components xx, yy, zz, xy, yz, zx
  Number rotation[9];  ///< row major
};

/// From strain increment and spin increment in the midpoint configuration. The midpoint strain increment d is seen from
/// the end of the step as R^(1/2) d R^(-1/2) = d + (w d - d w)/2 + O(w^2 d), w the spin increment: without the
/// second term the update s <- R s R^T + C d is of first order only (T. J. R. Hughes, J. Winget, Int. J. Numer. Meth.
/// Eng. 15 (1980) 1862 leave it out). Rigid motions give no strain and their exact rotation.
template <class Number>
BRUNT_INLINE StrainStep<Number> seen_from_end(const Number (&d)[6], const Number (&spin)[3]) {
  StrainStep<Number> step;
  geometry::rotation_of_spin(spin, step.rotation);
  const auto& [wx, wy, wz] = spin;
  const auto& [xx, yy, zz, xy, yz, zx] = d;
  step.strain[0] = xx - wz * xy + wy * zx;
  step.strain[1] = yy + wz * xy - wx * yz;
  step.strain[2] = zz - wy * zx + wx * yz;
  step.strain[3] = xy + 0.5 * (wz * (xx - yy) + wy * yz - wx * zx);
  step.strain[4] = yz + 0.5 * (wx * (yy - zz) + wz * zx - wy * xy);
  step.strain[5] = zx + 0.5 * (wy * (zz - xx) + wx * xy - wz * yz);
  return step;
}

/// Of the velocity gradient L (row major) times dt: symmetric part (xx, yy, zz, xy, yz, zx) and axial vector of the
/// skew part.
template <class Number>
BRUNT_INLINE void stretch_and_spin(const Number (&L)[9], double dt, Number (&d)[6], Number (&spin)[3]) {
  const double half = 0.5 * dt;
  for (int i = 0; i < 3; ++i) d[i] = dt * L[4 * i];
  d[3] = half * (L[1] + L[3]);
  d[4] = half * (L[5] + L[7]);
  d[5] = half * (L[2] + L[6]);
  spin[0] = half * (L[7] - L[5]);
  spin[1] = half * (L[2] - L[6]);
  spin[2] = half * (L[3] - L[1]);
}

/// Volume at the end of a step over that at its start: the step's gradient is (1 - D/2)^-1 (1 + D/2), D = L dt.
BRUNT_INLINE Pack volume_ratio(const Pack (&L)[9], double dt) {
  const auto determinant = [&](double half) {
    Pack F[9];
    for (int c = 0; c < 9; ++c) F[c] = half * L[c] + (c % 4 == 0 ? 1.0 : 0.0);
    return F[0] * (F[4] * F[8] - F[5] * F[7]) + F[1] * (F[5] * F[6] - F[3] * F[8]) + F[2] * (F[3] * F[7] - F[4] * F[6]);
  };
  return determinant(0.5 * dt) / determinant(-0.5 * dt);
}

/// For the Jaumann rate: all tensors rotate with the spin of the material.
template <class Number>
BRUNT_INLINE StrainStep<Number> strain_step(const Number (&L)[9], double dt) {
  Number d[6], spin[3];
  stretch_and_spin(L, dt, d, spin);
  return seen_from_end(d, spin);
}

/// Stress, history tensors and scalars of a rate law from the start of a step to its end; also returns the stress in
/// `s`. Returns the result of the law's update: the share of the elastic trial deviator that remains after plastic
/// flow. update(s, tensors, scalars): with quantities rotated to the end of the step.
template <class Response, class Number, class Update>
BRUNT_INLINE Number follow_stress(const StrainStep<Number>& step, const PointMemory<const Pack>& committed,
                                  const PointMemory<Number>& trial, Number (&s)[6], const Update& update) {
  constexpr int tensor_entries = 6 * Response::tensors;
  Number tensors[std::max(tensor_entries, 1)], scalars[std::max(Response::scalars, 1)];
  for (int c = 0; c < 6; ++c) s[c] = committed.stress[c];
  for (int c = 0; c < tensor_entries; ++c) tensors[c] = committed.tensors[c];
  for (int k = 0; k < Response::scalars; ++k) scalars[k] = committed.scalars[k * committed.stride];
  geometry::rotate_tensor(step.rotation, s);
  for (int t = 0; t < Response::tensors; ++t) geometry::rotate_tensor(step.rotation, tensors + 6 * t);
  const Number left = update(s, tensors, scalars);
  for (int c = 0; c < 6; ++c) trial.stress[c] = s[c];
  for (int c = 0; c < tensor_entries; ++c) trial.tensors[c] = tensors[c];
  for (int k = 0; k < Response::scalars; ++k) trial.scalars[k * trial.stride] = scalars[k];
  return left;
}

template <class Response, class Number>
BRUNT_INLINE Number update_stress(const Response& law, const StrainStep<Number>& step,
                                  const PointMemory<const Pack>& committed, const PointMemory<Number>& trial,
                                  Number (&s)[6]) {
  return follow_stress<Response>(step, committed, trial, s, [&](Number(&stress)[6], Number* tensors, Number* scalars) {
    return law.update(step.strain, stress, tensors, scalars);
  });
}

/// For a law that needs circumstances, with its tangent at the end of the step.
template <class Response>
BRUNT_INLINE Pack update_stress(const Response& law, const StrainStep<Pack>& step,
                                const typename Response::Step& circumstances, const PointMemory<const Pack>& committed,
                                const PointMemory<Pack>& trial, Pack (&s)[6], Pack& lambda, Pack& mu) {
  return follow_stress<Response>(step, committed, trial, s, [&](Pack(&stress)[6], Pack*, Pack* scalars) {
    const Pack left = law.update(step.strain, circumstances, stress, scalars);
    law.tangent(stress, scalars, lambda, mu);
    return left;
  });
}

/// rho c^2 of pressure waves: of the virgin material, or at the start of the step if the law needs circumstances.
template <class Response>
BRUNT_INLINE auto wave_modulus(const Response& law, const PointMemory<const Pack>& committed) {
  if constexpr (Thermodynamic<Response>) {
    Pack s[6], scalars[Response::scalars];
    for (int c = 0; c < 6; ++c) s[c] = committed.stress[c];
    for (int k = 0; k < Response::scalars; ++k) scalars[k] = committed.scalars[k * committed.stride];
    return law.modulus(s, scalars);
  } else {
    return law.lambda + 2.0 * law.mu;
  }
}

}  // namespace brunt::element
