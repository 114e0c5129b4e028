// SPDX-License-Identifier: Apache-2.0
// Drilling: rotations of the corners about the normal of a shell, to which its strains do not react.
//
// On a curved surface the normals of neighbouring elements differ, so the rotation of a node about the one bends the
// other. Without any stiffness these rotations grow as the mesh is refined, and free each edge to turn like a hinge:
// the roof of Scordelis and Lo gives 1.19 and 1.35 of its deflection with 16 and 32 one-point quadrilaterals a side. A
// weak spring therefore holds the rotations to the spin of the element in its plane (T. J. R. Hughes, F. Brezzi,
// Comput. Methods Appl. Mech. Eng. 72 (1989) 105),
//   energy  share mu h^3 / 2 mean_I (r_I . n - spin)^2,
// of the order of bending: a stiffness of the order of the membrane's locks thin shells (README.md).
#pragma once
#include "core/simd.hpp"

namespace brunt::element {

constexpr double drilling_share = 0.1;

/// Of the mean of the squares over A h [stress].
BRUNT_INLINE Pack drilling_stiffness(double mu, Pack thickness, Pack over_area) {
  return (drilling_share * mu) * thickness * thickness * over_area;
}

/// Moments on the modes of r . n - spin at the end of the step, `weight` the mean square of each; adds their work in
/// the step. `left`: share that flow leaves, as of bending stresses.
template <int modes>
BRUNT_INLINE void resist_drilling(const Pack (&rate)[modes], const double (&weight)[modes], Pack stiffness, Pack left,
                                  double dt, const Pack* committed, Pack* trial, Pack& work, Pack (&moment)[modes]) {
  for (int k = 0; k < modes; ++k) {
    const Pack before = committed[k];
    moment[k] = left * (before + (dt * weight[k]) * stiffness * rate[k]);
    work += (0.5 * dt) * (before + moment[k]) * rate[k];
    trial[k] = moment[k];
  }
}

}  // namespace brunt::element
