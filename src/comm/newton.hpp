// SPDX-License-Identifier: Apache-2.0
// Newton's method for r(x) = 0 over the ranks: x <- x - s c with K(x) c = r(x), driven by PETSc's SNES. Convergence,
// the step length s and failure are decided by the caller's functions only, never by a norm of PETSc (which depends on
// the ranks). The iterates therefore have the same bits on any number of ranks if the functions have.
#pragma once
#include <functional>
#include <span>

#include "comm/communicator.hpp"

namespace brunt::comm {

enum class NewtonVerdict { go_on, converged, give_up };

/// The data for a line search. Spans hold the owned unknowns and are valid during the call.
struct NewtonStep {
  int iteration = 0;                   ///< corrections taken before this one
  std::span<const double> x;           ///< before the correction
  std::span<const double> residual;    ///< r(x)
  std::span<const double> correction;  ///< c
  /// Writes r(x - share c) to `trial`; false: not admissible there. Collective.
  std::function<bool(double share, std::span<double> trial)> residual_at;
};

/// All functions are collective and return the same result on every rank. Spans hold the owned unknowns of this rank,
/// in the order of its owned rows (possibly none). Exceptions leave `newton` unchanged.
struct NewtonProblem {
  /// r at x; false: x is not admissible (an inverted element). Before `judge` and `solve` at x, the last call was at x.
  std::function<bool(std::span<const double> x, std::span<double> residual)> residual;
  /// c of K(x) c = r; false: K is singular.
  std::function<bool(std::span<const double> x, std::span<const double> residual, std::span<double> correction)> solve;
  /// The convergence test, at the start (iteration 0) and after each correction. It also limits the number of
  /// iterations.
  std::function<NewtonVerdict(int iteration, std::span<const double> x, std::span<const double> residual)> judge;
  /// The factor s in (0, 1] of the correction; 0: no admissible one exists. Without this function full corrections are
  /// applied.
  std::function<double(const NewtonStep& step)> step_length;
};

enum class NewtonReason {
  converged,
  gave_up,       ///< `judge` said so
  inadmissible,  ///< `residual` rejected the starting point, or the point reached by a correction
  singular,      ///< `solve` failed
  no_step,       ///< `step_length` found none
};

struct NewtonResult {
  NewtonReason reason = NewtonReason::gave_up;
  int iterations = 0;  ///< corrections taken
};

/// Starts at `x`, which holds the last admissible point on return. Collective.
[[nodiscard]] NewtonResult newton(const Communicator& ranks, std::span<double> x, const NewtonProblem& problem);

}  // namespace brunt::comm
