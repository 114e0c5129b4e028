// SPDX-License-Identifier: Apache-2.0
// The iterative rate constraint of Heinstein et al. 2000, eq. (26): impulses that the rows admit, such that every row
// has what it asks for where its impulse acts. Each iteration updates all rows from the previous iterate,
//   p <- admitted(p + alpha missing / H),
// with H the row sums (see system.hpp) in place of the paper's eq. (29).
// - row sums alone: alpha = 1. Descends monotonically for any masses and meshes; stopped early it never gives energy.
// - conjugate residuals, where no row has Coulomb friction, or rigid bodies take part: see conjugate.hpp.
// - Barzilai-Borwein, elsewhere: alpha is the quotient s.Hs / s.As or s.As / As.H^-1 As of the last change s of the
//   impulses, which is 1 or more (Barzilai and Borwein, IMA J. Numer. Anal. 8, 1988; projected: Dai and Fletcher,
//   Numer. Math. 100, 2005). The two alternate without a period: a metal strip bent over round supports with friction,
//   7600 steps, ended 8 of them at the limit, with strict turns 36, and a clamped block 0 for 3. Where thirty
//   iterations have not halved the residual a few sweeps of row sums come in between, in the last quarter of
//   max_iterations nothing else (rows that nearly contradict each other have no end, and what is left then depends on
//   where long steps are stopped); it ends with one, since a long step stopped half-way is a rebound that nothing in
//   the bodies has asked for.
// Conjugate residuals have half of the iterations (with friction three quarters: falling stacks ended seven steps of
// 2000 at the limit with half, one with these, since what comes after needs more): where rows change sides over and
// over they may wander for ever, far above where they began (residuals of 28 where steps need 20 and 70 at most); the
// rest is left to Barzilai-Borwein. A warm start may be within the tolerance before anything is done. To leave it at
// that would let bodies at rest float on forces that answer to nothing, until they have moved by the tolerance; to
// correct it a little in each step is a soft spring, which the recovery of gaps turns into an engine (its force lags).
// So it goes on until 0.03 are left of what it began with, or 1e-8 of the tolerance, and makes one sweep at least: what
// stirs bodies dies out (with 0.1 and 1e-6 the energy of cubes stacked at rest grew by e in 6000 steps, from 1e-20 J to
// 3e-6 J in a million). That takes 2.3 iterations a step in the mean and 6 at most in cases/stack, none in impacts.
// They count in max_iterations, but a step that ends there within the tolerance has not ended at the limit (see
// ended_at_limit).
// Through chains of rigid bodies the same residual stands for more motion, the more the higher they are: there it goes
// on until 0.001 are left (with 0.03 six boxes at rest stir by up to 4e-9 m and ten swing by 3e-7 m for ever; with
// 0.001 both come to rest to 1e-15 m in 20000 steps; twenty would need 0.0003).
#pragma once
#include <algorithm>
#include <limits>
#include <utility>

#include "brunt/contact/enforcement/enforce.hpp"

namespace brunt::contact {

enum class StepLength {
  row_sum,
  longer  ///< conjugate residuals or Barzilai-Borwein steps
};

/// Has the residual been halved in so many iterations? Else a few sweeps of row sums, which descend, come in between.
/// (To go on with them alone took more than 200 iterations where five of them and long steps again take 60; more of
/// them each time took 2000 to 1e-6 where the same five take 500.)
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

/// Of the velocities: no residual below it is worth an iteration.
constexpr double rounding_share = 1e-15;

/// The residual to end with, of the one to start from: see above.
double residual_to_reach(const System& system, const EnforcementSettings& settings, double first);

/// As `enforce`; scratch.diagonal is formed here.
EnforcementResult enforce_rate_constraint(const System& system, const EnforcementSettings& settings, StepLength length,
                                          Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                          EnforcementScratch& scratch);

/// The same with scratch.diagonal as it is (any H, without guarantee), from impulses and velocities that belong
/// together. coupled: of this rank's rows, see form_row_sums.
EnforcementResult iterate(const System& system, const EnforcementSettings& settings, StepLength length, bool coupled,
                          double violation, Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                          EnforcementScratch& scratch);

}  // namespace brunt::contact
