// SPDX-License-Identifier: Apache-2.0
// Data of a step, other than the strain, for laws with rates or an equation of state. Such laws provide for the kernels
//   thermodynamic    true
//   Step             = Circumstances
//   fields           names and initial values of the scalars, in order
//   update(de, circumstances, stress, scalars)
//   modulus(stress, scalars)        rho c^2 of pressure waves, for bulk viscosity
//   tangent(stress, scalars, lambda, mu)
//   at_volume        position of the relative volume among the scalars, or -1
#pragma once
#include "core/simd.hpp"

namespace brunt::material {

struct Circumstances {
  double dt = 0;      ///< of the step [time]; 0 in the first of a run
  Pack volume;        ///< at the end of the step over that of the reference
  Pack viscous_work;  ///< that bulk viscosity did in the step, over the reference volume [energy/length^3]
};

/// A named scalar of the history.
struct ScalarField {
  const char* name;
  double start;
};

}  // namespace brunt::material
