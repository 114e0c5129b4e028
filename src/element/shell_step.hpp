// SPDX-License-Identifier: Apache-2.0
// Moduli of plane stress, and what bounds of the frequency of shells have in common.
//
// Strains are grouped (membrane, bending, shear, hourglass). With D the stiffness of a group, B its strains of the
// motion and M the lumped mass, the largest eigenvalue of sum B^T D B against M is at most the largest, over families
// of degrees of freedom, of what the groups charge to them: a group that acts on the families f with the norms n_f
// takes
//   (sum n_f x_f)^2 <= (1 + e) n_1^2 x_1^2 + (1 + 1/e) n_2^2 x_2^2      for any e > 0.
#pragma once
#include "core/simd.hpp"
#include "element/shell_layers.hpp"

namespace brunt::element {

/// Of the virgin material.
struct ShellModuli {
  double lambda, mu;  ///< of plane stress, stress = lambda tr(e) 1 + 2 mu e
  double shear;       ///< of the transverse shears, corrected
  double young;

  ShellModuli(double lambda_solid, double mu_solid)
      : lambda(2 * lambda_solid * mu_solid / (lambda_solid + 2 * mu_solid)),
        mu(mu_solid),
        shear(shear_correction * mu_solid),
        young(mu_solid * (3 * lambda_solid + 2 * mu_solid) / (lambda_solid + mu_solid)) {}

  /// Of |grad v|^2, with `stress` a bound of the norm of the initial stress: |lambda tr^2 + 2 mu D : D| is at most this
  /// times |v,xi|^2 + |v,eta|^2, where the reciprocal metric has this largest eigenvalue and trace. Equal on squares.
  BRUNT_INLINE Pack in_plane(Pack stress, Pack largest, Pack trace) const {
    return pack_max(lambda + 2.0 * stress, broadcast(0.0)) * trace + 2.0 * (mu + stress) * largest;
  }
};

/// The least rotary inertia over mass with which shear does not govern: shear charges
/// k mu (metric + m/J), the membrane lambda trace + 2 mu metric. At least `bending`, that of the fibres.
BRUNT_INLINE Pack inertia_over_mass(const ShellModuli& moduli, Pack largest, Pack trace, Pack bending) {
  const Pack membrane = moduli.in_plane(broadcast(0.0), largest, trace);
  const Pack rest = pack_max(membrane - moduli.shear * largest, 0.1 * membrane);
  return pack_max(bending, moduli.shear / rest);
}

}  // namespace brunt::element
