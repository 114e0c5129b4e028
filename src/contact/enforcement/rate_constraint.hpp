// SPDX-License-Identifier: Apache-2.0
// The iterative rate constraint of Heinstein et al. 2000, eq. (26): admissible impulses such that every row with an
// impulse has its required rate. Each iteration updates all rows from the previous iterate,
//   p <- admitted(p + alpha missing / H),
// with H the row sums (see system.hpp) instead of the paper's eq. (29).
// - row sums only: alpha = 1. Monotone for any masses and meshes; it never supplies energy, even if it is stopped
// early.
// - conjugate residuals, if no row has Coulomb friction, or rigid bodies take part: see conjugate.hpp.
// - Barzilai-Borwein, otherwise: alpha is the quotient s.Hs / s.As or s.As / As.H^-1 As of the last change s of the
// impulses, at least 1 (Barzilai and Borwein, IMA J. Numer. Anal. 8, 1988; projected: Dai and Fletcher, Numer. Math.
// 100, 2005). The two alternate without a fixed period, which reaches the limit of iterations less often than strict
// alternation. If thirty iterations have not halved the residual, a few sweeps of row sums follow, and in the last
// quarter of max_iterations only these are used: nearly contradictory rows do not converge, and the remainder would
// depend on where long steps are stopped. The iteration ends with a sweep, since a long step without its successor is a
// rebound without physical cause.
//
// Conjugate residuals have half of the iterations (with friction three quarters, since the following steps need more).
// If rows keep changing sides they may diverge, far above the initial residual; the remaining iterations use
// Barzilai-Borwein steps.
//
// A warm start may be within the tolerance before the first iteration. Accepting it would let bodies at rest be carried
// by forces without equilibrium until they have moved by the tolerance; correcting it slightly in each step acts as a
// soft spring, which supplies energy together with the recovery of gaps (its force lags). The iteration therefore
// continues to 0.03 of the initial residual, or to 1e-8 of the tolerance, with at least one sweep: perturbations of
// bodies at rest then decay (with 0.1 and 1e-6 they grow). This costs a few iterations in each step at rest, and none
// in impacts. They count in max_iterations, but a step that ends there within the tolerance has not ended at the limit
// (see ended_at_limit).
//
// In chains of rigid bodies the same residual corresponds to more motion, increasing with their height: the iteration
// continues to 0.001 of the initial residual, with which stacks of six to ten boxes come to rest; twenty would need
// 0.0003.
#pragma once
#include <algorithm>
#include <limits>
#include <utility>

#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

enum class StepLength {
  row_sum,
  longer  ///< conjugate residuals or Barzilai-Borwein steps
};

/// Whether the residual has been halved within this number of iterations. If not, a few sweeps of row sums follow,
/// which decrease monotonically. (Sweeps only would need several times as many iterations; more sweeps each time also
/// converge more slowly.)
class Stall {
 public:
  explicit Stall(int patience) : patience_(patience) {}
  /// 0: none.
  int sweeps_due(int iteration, double residual) {
    constexpr int few = 5;
    best_ = std::min(best_, residual);
    if (iteration % patience_ != 0) return 0;
    return best_ <= 0.5 * std::exchange(before_, best_) ? 0 : few;
  }

 private:
  int patience_;
  double best_ = std::numeric_limits<double>::infinity(), before_ = best_;
};

/// Share of the velocities: a smaller residual is rounding.
constexpr double rounding_share = 1e-15;

/// The final residual, for this initial one: see above.
double residual_to_reach(const System& system, const EnforcementSettings& settings, double first);

/// As `enforce`; scratch.diagonal is formed here.
EnforcementResult enforce_rate_constraint(const System& system, const EnforcementSettings& settings, StepLength length,
                                          Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                          EnforcementScratch& scratch);

/// The same with scratch.diagonal as it is (any H, without guarantee), from consistent impulses and velocities.
/// coupled: for this rank's rows, see form_row_sums.
EnforcementResult iterate(const System& system, const EnforcementSettings& settings, StepLength length, bool coupled,
                          double violation, Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                          EnforcementScratch& scratch);

}  // namespace brunt::contact
