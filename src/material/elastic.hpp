// SPDX-License-Identifier: Apache-2.0
// Isotropic linear elasticity in rate form, and the tangent bound shared by all rate laws.
#pragma once
#include "core/simd.hpp"
#include "material/law.hpp"

namespace brunt::material {

// Every response provides the following to the element kernels:
//   hyperelastic     false: rate law, update(), which returns the share of the trial deviator that plastic flow leaves;
//                    true: stress from the deformation gradient, stress()
//   logarithmic      (rate laws) true: the element turns stresses with the spin of the logarithmic rate
//   tensors          symmetric tensors in the history that the element rotates with the material, after the stress
//   scalars          further history
//   density, lambda, mu   constants of the virgin material, for hourglass control and bulk viscosity
// Symmetric tensors are stored xx, yy, zz, xy, yz, zx with tensor (not engineering) shear components.

/// Bound of the current stiffness of a rate law, initial stress included: for every velocity gradient L with
/// symmetric part D, the second-order power L : dP/dt (nominal stress P, current reference) obeys
///   L : dP/dt <= lambda tr(L)^2 + 2 mu L : L.
/// For the Jaumann rate, L : dP/dt = D : C : D + tr(D) s : D + [W^T W s] + 2 [W s D] - [D D s]. With s = m 1 + dev,
/// the bracket terms are at most (|m| + |dev|) L : L and tr(D) s : D at most m tr^2 + |dev| (3/2 tr^2 + 1/2 L : L);
/// the spectral norm |dev| is at most sqrt(2/3) of the Frobenius norm (dev has no trace), exactly so in uniaxial
/// stress, and independent of the orientation of the scene. Compression reduces lambda and increases mu.
///
/// The logarithmic rate rotates the stress by N in addition to W, which adds [(s D - D s) N]. With |N| <= |D| (see
/// element/logarithmic_rate.hpp) this is at most the largest difference of principal stresses times L : L, and that
/// difference is at most sqrt(2) of the Frobenius norm, sqrt(3) |dev|. `spin` is half of it: 0 for the Jaumann rate,
/// logarithmic_share for the logarithmic one.
constexpr double logarithmic_share = 0.86602540378443864676;  ///< sqrt(3)/2
template <class Lambda, class Mu>
BRUNT_INLINE void rate_law_tangent(Lambda elastic_lambda, Mu elastic_mu, const Pack (&stress)[6], Pack& lambda,
                                   Pack& mu, double spin = 0) {
  const Pack mean = (stress[0] + stress[1] + stress[2]) * (1.0 / 3.0);
  Pack norm2 = 2.0 * (stress[3] * stress[3] + stress[4] * stress[4] + stress[5] * stress[5]);
  for (int i = 0; i < 3; ++i) norm2 += (stress[i] - mean) * (stress[i] - mean);
  const Pack dev_norm = pack_sqrt((2.0 / 3.0) * norm2);
  lambda = elastic_lambda + mean + 1.5 * dev_norm;
  mu = elastic_mu + 0.5 * pack_abs(mean) + (0.75 + spin) * dev_norm;
}

/// Hooke's law for the increment: d stress = lambda tr(de) 1 + 2 mu de.
template <class Number>
BRUNT_INLINE void add_elastic_increment(double lambda, double mu, const Number (&de)[6], Number (&stress)[6]) {
  const Number volumetric = lambda * (de[0] + de[1] + de[2]);
  const double two_mu = 2.0 * mu;
  for (int i = 0; i < 3; ++i) {
    stress[i] += volumetric + two_mu * de[i];
    stress[i + 3] += two_mu * de[i + 3];
  }
}

struct ElasticResponse {
  static constexpr bool hyperelastic = false;
  static constexpr bool logarithmic = false;
  static constexpr int tensors = 0;
  static constexpr int scalars = 0;

  explicit ElasticResponse(const Elastic& constants) {
    const ElasticModuli moduli = initial_moduli(constants);
    density = moduli.density;
    lambda = moduli.lambda;
    mu = moduli.mu;
  }

  /// Stress at the end of the step from the stress rotated to the end of the step and the strain increment de.
  template <class Number>
  Number update(const Number (&de)[6], Number (&stress)[6], Number* /*tensors*/, Number* /*scalars*/) const {
    add_elastic_increment(lambda, mu, de, stress);
    return broadcast(1.0);
  }

  /// See rate_law_tangent.
  void tangent(const Pack (&stress)[6], Pack& lambda_bound, Pack& mu_bound) const {
    rate_law_tangent(lambda, mu, stress, lambda_bound, mu_bound);
  }

  double density, lambda, mu;
};

/// A rate law whose stresses follow the logarithmic rate instead of Jaumann's.
template <class Law>
struct Logarithmic : Law {
  static constexpr bool logarithmic = true;
  using Law::Law;

  /// See rate_law_tangent.
  void tangent(const Pack (&stress)[6], Pack& lambda_bound, Pack& mu_bound) const {
    rate_law_tangent(this->lambda, this->mu, stress, lambda_bound, mu_bound, logarithmic_share);
  }
};

}  // namespace brunt::material
