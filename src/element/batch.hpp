// SPDX-License-Identifier: Apache-2.0
// Input and output of an element kernel: a batch of elements at once (one for each lane of a pack).
//
// A kernel is a small struct with its constants, templated over a material response, and
//   static constexpr int nodes, history_size;   corners an element; numbers of its history
//   std::vector<HistoryField> history() const;  their names, in order
//   void operator()(const BatchMotion<nodes>&, const Pack* committed, Pack* trial, BatchForce<nodes>&) const;
// `committed` is the history at the start of the step, `trial` at its end: every entry except the mass, which no step
// changes, is written. Both may be the same memory, as in an explicit step. A kernel knows neither MPI nor files, nor
// how elements are stored.
#pragma once
#include <string>
#include <type_traits>
#include <vector>

#include "core/simd.hpp"

namespace brunt::element {

/// A named part of the history of an element: `components` doubles for each element.
struct HistoryField {
  std::string name;  ///< "stress", "plastic_strain", "hourglass_force" ...
  int components = 1;
  double start = 0;  ///< of all components
};

template <int nodes, class Number = Pack>
struct BatchMotion {
  Number x[3][nodes];  ///< positions at the end of the step [length]
  Number v[3][nodes];  ///< mean velocities of the step, so that v dt is the increment [length/time]
  Pack X[3][nodes];    ///< reference positions, filled for hyperelastic laws only
  double dt = 0;       ///< of the step; zero in the first of a run, when nothing has been strained yet
};

/// A linear element that resists every motion at least as much as this one does now: one point, with springs and
/// dashpots on its hourglass modes. The assembled mesh of such elements bounds the step (force/assembled.hpp).
struct BatchStiffness {
  Pack lambda, mu;                ///< tangent moduli [stress]
  Pack viscosity;                 ///< bulk viscosity [stress time]
  Pack spring = broadcast(0.0);   ///< of each hourglass mode [force/length]
  Pack dashpot = broadcast(0.0);  ///< likewise [force/velocity]
  Pack plane2;                    ///< omega^2 of the fastest plane wave in a regular mesh of such elements [1/time^2]
};

template <int nodes, class Number = Pack>
struct BatchForce {
  Number f[3][nodes];        ///< minus the internal force on each corner [force]
  Pack rate;                 ///< at least 1 / (largest stable step) of the free element [1/time]
  Pack volume;               ///< not positive (or NaN) for an inverted element [length^3]
  BatchStiffness stiffness;  ///< not read in most steps
};

/// Rate and volume are computed for packs only: for other numbers (core/dual.hpp) only forces are needed.
template <class Number>
constexpr bool bounds_step = std::is_same_v<Number, Pack>;

/// Upper bound of the largest eigenvalue of a symmetric positive 3x3 (xx,yy,zz,xy,yz,zx): trace/3 + sqrt(2/3)
/// |deviator|, exact when two eigenvalues are equal and the third is not smaller.
template <class Number>
BRUNT_INLINE Number largest_eigenvalue_bound(const Number (&s)[6]) {
  const Number mean = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
  const Number a = s[0] - mean, b = s[1] - mean, c = s[2] - mean;
  const Number norm2 = a * a + b * b + c * c + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  return mean + pack_sqrt((2.0 / 3.0) * norm2);
}

/// 1/(largest stable step) of central differences with damping taken at the half step before:
/// dt = 2/omega (sqrt(1+xi^2) - xi) with xi = damping / (2 omega) (T. Belytschko, W. K. Liu, B. Moran, Nonlinear Finite
/// Elements for Continua and Structures, 2000, eq (6.2.26)), written without a division.
BRUNT_INLINE Pack stable_rate(Pack omega2, Pack damping) {
  return 0.5 * pack_sqrt(omega2 + 0.25 * damping * damping) + 0.25 * damping;
}

}  // namespace brunt::element
