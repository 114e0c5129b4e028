// SPDX-License-Identifier: Apache-2.0
// Newton's iteration for r(x) = 0 over the ranks: x <- x - s c with K(x) c = r(x). PETSc's SNES drives it; what is
// decided - convergence, the share s, giving up - is decided by the caller's functions alone, never by a norm of PETSc
// (which depends on the ranks), so the iterates have the same bits on any number of ranks if the functions have.
#pragma once
#include <functional>
#include <span>

#include "brunt/comm/communicator.hpp"

namespace brunt::comm {

enum class NewtonVerdict { go_on, converged, give_up };

/// What a line search sees. Spans hold the owned unknowns and are valid during the call.
struct NewtonStep {
  int iteration = 0;                   ///< corrections taken before this one
  std::span<const double> x;           ///< before the correction
  std::span<const double> residual;    ///< r(x)
  std::span<const double> correction;  ///< c
  /// r(x - share c) into `trial`; false: not admissible there. Collective.
  std::function<bool(double share, std::span<double> trial)> residual_at;
};

/// All functions are collective and give every rank the same answer. Spans hold this rank's owned unknowns, in the
/// order of its owned rows (none on some ranks is fine). What they throw comes out of `newton` unchanged.
struct NewtonProblem {
  /// r at x; false: x is not admissible (an inverted element). Before `judge` and `solve` at x, this was called last at
  /// x.
  std::function<bool(std::span<const double> x, std::span<double> residual)> residual;
  /// c of K(x) c = r; false: K is singular.
  std::function<bool(std::span<const double> x, std::span<const double> residual, std::span<double> correction)> solve;
  /// The convergence test, at the start (iteration 0) and after each correction. Limits iterations, too.
  std::function<NewtonVerdict(int iteration, std::span<const double> x, std::span<const double> residual)> judge;
  /// The share s of the correction that is taken, in (0, 1]; 0: none is good. Without it full corrections are taken.
  std::function<double(const NewtonStep& step)> step_length;
};

enum class NewtonReason {
  converged,
  gave_up,       ///< `judge` said so
  inadmissible,  ///< `residual` refused the start or the point that a correction led to
  singular,      ///< `solve` failed
  no_step,       ///< `step_length` found none
};

struct NewtonResult {
  NewtonReason reason = NewtonReason::gave_up;
  int iterations = 0;  ///< corrections taken
};

/// From the start in `x`, which holds the last point that was admissible at the end. Collective.
[[nodiscard]] NewtonResult newton(const Communicator& ranks, std::span<double> x, const NewtonProblem& problem);

}  // namespace brunt::comm
