// SPDX-License-Identifier: Apache-2.0
// Stability of static states. A state is stable if every small motion that contact, ties and supports admit needs work
// (Dirichlet, Hill): the symmetric part of the matrix is positive on these motions. With one row and column for each
// multiplier it then has as many negative eigenvalues as there are multipliers in action; each further one is a
// direction in which the state moves away by itself (Y. Chabrillac and J.-P. Crouzeix, Linear Algebra Appl. 63 (1984)
// 283).
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "comm/symmetric_system.hpp"
#include "model/implicit_solver.hpp"

namespace brunt::implicit {

struct Scene;
struct Solver;

/// Every so many steps the state is examined, and at the end of the run: an examination costs about as much as an
/// iteration.
constexpr int steps_between_examinations = 4;

/// Stability is lost or regained, or a step jumps over a limit point.
struct StabilityChange {
  static constexpr GlobalIndex unknown = -1;  ///< the matrix could not be factorised
  static constexpr GlobalIndex jump = -2;     ///< of the step from time_before to time
  double time_before = 0, time = 0;           ///< of the last state examined before it, and of the first one after it
  GlobalIndex directions = 0;                 ///< in which the state moves away by itself; 0: regained
  GlobalIndex gid = -1;  ///< canonical number of the node that moves most in the most unstable of them, or in the jump
  double released = 0;   ///< of a jump: energy that was not stored, over the work of the step
};

struct Stability {
  double directions = 0;                 ///< of the last state examined, a whole number: saved with its time
  double examined = 0;                   ///< [time]
  bool failed = false;                   ///< the matrix could not be factorised in some step
  bool jumped = false;                   ///< a jump has been told
  std::vector<StabilityChange> changes;  ///< that have not been told
  std::shared_ptr<comm::SymmetricSystem> system{};
  std::vector<Rank> owner_of{};  ///< by unknown of the whole system
  double last_time = std::numeric_limits<double>::infinity(), last_step = last_time;  ///< of the run
};

[[nodiscard]] inline bool watches_stability(const model::ImplicitSolver& settings) {
  return settings.stability && settings.scheme == model::Scheme::statics;
}

/// At the accepted iterate, before its commit: whether the step jumps from one state to another that no states of
/// equilibrium connect, as in snap-through. External forces do at least the smaller one of their works at both ends of
/// the step; where the elements store less, something was released. Told once. Collective.
void watch_jumps(const Scene& scene, Solver& solver);

/// At the accepted iterate, before its commit, if an examination is due. Collective.
void watch_stability(const Scene& scene, Solver& solver);

}  // namespace brunt::implicit
