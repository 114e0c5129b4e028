// SPDX-License-Identifier: Apache-2.0
// Compressible neo-Hookean solid: Cauchy stress and stiffness bound from the deformation gradient.
#pragma once
#include "core/simd.hpp"
#include "material/law.hpp"
#include "material/logarithm.hpp"

namespace brunt::material {

/// psi = mu/2 (tr b - 3) - mu ln J + lambda/2 (ln J)^2 per reference volume, b = F F^T
/// (J. Bonet, R. D. Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, section 6.4.3).
struct NeoHookeanResponse {
  static constexpr bool hyperelastic = true;
  static constexpr bool logarithmic = false;
  static constexpr int tensors = 0;
  static constexpr int scalars = 0;

  explicit NeoHookeanResponse(const NeoHookean& constants)
      : density(constants.density), lambda(constants.lambda), mu(constants.mu) {}

  /// Cauchy stress (mu (b - 1) + lambda ln J 1) / J; F[3 i + j] = dx_i/dX_j. Not-a-number where det F <= 0.
  template <class Number>
  void stress(const Number (&F)[9], Number (&cauchy)[6]) const {
    Number b[6];
    left_cauchy_green(F, b);
    const Number J = determinant(F);
    const Number inverse = 1.0 / J;
    const Number scale = mu * inverse, pressure = (lambda * pack_log(J) - mu) * inverse;
    for (int i = 0; i < 3; ++i) {
      cauchy[i] = scale * b[i] + pressure;
      cauchy[i + 3] = scale * b[i + 3];
    }
  }

  /// Bound of the current stiffness: for every spatial velocity gradient L with symmetric part D,
  ///   (1/J) dP/dt : dF/dt <= lambda_bound tr(L)^2 + 2 mu_bound L : L       (P first Piola-Kirchhoff stress),
  /// initial stress included. The left side is exactly [lambda tr(L)^2 + k tr(L L) + mu tr(L b L^T)] / J with
  /// k = mu - lambda ln J; |tr(L L)| <= L : L, and the largest eigenvalue of b is at most
  /// tr(b)/3 + sqrt(2/3) |dev b|, exact in uniaxial stretch.
  void tangent(const Pack (&F)[9], Pack& lambda_bound, Pack& mu_bound) const {
    Pack b[6];
    left_cauchy_green(F, b);
    const Pack J = determinant(F);
    const Pack inverse = 1.0 / J;
    const Pack mean = (b[0] + b[1] + b[2]) * (1.0 / 3.0);
    Pack deviator = 2.0 * (b[3] * b[3] + b[4] * b[4] + b[5] * b[5]);
    for (int i = 0; i < 3; ++i) deviator += (b[i] - mean) * (b[i] - mean);
    const Pack stretch = mean + pack_sqrt((2.0 / 3.0) * deviator);
    lambda_bound = lambda * inverse;
    mu_bound = 0.5 * inverse * (pack_abs(mu - lambda * pack_log(J)) + mu * stretch);
  }

  double density, lambda, mu;

 private:
  template <class Number>
  static Number determinant(const Number (&F)[9]) {
    return F[0] * (F[4] * F[8] - F[5] * F[7]) + F[1] * (F[5] * F[6] - F[3] * F[8]) + F[2] * (F[3] * F[7] - F[4] * F[6]);
  }
  template <class Number>
  static void left_cauchy_green(const Number (&F)[9], Number (&b)[6]) {
    const auto rows = [&](int i, int j) {
      return F[3 * i] * F[3 * j] + F[3 * i + 1] * F[3 * j + 1] + F[3 * i + 2] * F[3 * j + 2];
    };
    b[0] = rows(0, 0);
    b[1] = rows(1, 1);
    b[2] = rows(2, 2);
    b[3] = rows(0, 1);
    b[4] = rows(1, 2);
    b[5] = rows(2, 0);
  }
};

}  // namespace brunt::material
