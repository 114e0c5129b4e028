// SPDX-License-Identifier: Apache-2.0
// Settings of implicit time integration: the section `solver` of a scene, with defaults filled in.
#pragma once
#include <cstdint>

namespace brunt::model {

enum class Scheme : std::int8_t {
  statics,           ///< equilibrium at every t_n; time orders loads, and enters rate laws
  contact_implicit,  ///< trapezoidal rule, except for contact forces, which act as at the end of the step
  hht,               ///< Hilber, Hughes, Taylor (1977): damps high frequencies
  newmark            ///< trapezoidal rule
};

enum class LinearSolver : std::int8_t {
  direct,  ///< factorised on one rank: bitwise the same on any number of ranks
  mumps    ///< factorised by all ranks: not bitwise the same
};

struct ImplicitSolver {
  Scheme scheme = Scheme::contact_implicit;
  double step = 0;           ///< length of the first step; steps are this times a power of two [time]
  double min_step = 0;       ///< below it the run stops [time]
  double max_step = 0;       ///< [time]
  double tolerance = 1e-10;  ///< of the unbalanced forces, relative to the acting ones
  LinearSolver linear = LinearSolver::direct;
  bool stability = true;  ///< of static states: tell where they lose it and regain it
  double alpha = 0.05;    ///< of hht, 0 (trapezoidal rule) to 1/3 (most damping)
};
constexpr int step_bounds = 3;  ///< step, min_step, max_step: saved with the state

}  // namespace brunt::model
