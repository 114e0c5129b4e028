// SPDX-License-Identifier: Apache-2.0
// How an implicit scene goes through time: what its `solver` says, with defaults filled in.
#pragma once
#include <cstdint>

namespace brunt::model {

enum class Scheme : std::int8_t {
  statics,           ///< forces in balance at every t_n; time orders loads, and rate laws see it
  contact_implicit,  ///< trapezoidal rule for all but contact, which acts as at the end of the step
  hht,               ///< Hilber, Hughes, Taylor (1977): damps what the step does not resolve
  newmark            ///< trapezoidal rule
};

enum class LinearSolver : std::int8_t {
  direct,  ///< factorised on one rank: the same bits on any number of ranks
  mumps    ///< factorised by all ranks: not the same bits
};

struct ImplicitSolver {
  Scheme scheme = Scheme::contact_implicit;
  double step = 0;           ///< length of the first step; steps are this times a power of two [time]
  double min_step = 0;       ///< below it the run stops [time]
  double max_step = 0;       ///< [time]
  double tolerance = 1e-10;  ///< of the forces that are left, over those that act
  LinearSolver linear = LinearSolver::direct;
  double alpha = 0.05;  ///< of hht, 0 (trapezoidal rule) to 1/3 (most damping)
};

}  // namespace brunt::model
