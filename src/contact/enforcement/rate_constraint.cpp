// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/rate_constraint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/enforcement/conjugate.hpp"
#include "contact/enforcement/energy_guard.hpp"
#include "contact/enforcement/softness.hpp"
#include "core/fixed_sum.hpp"

namespace brunt::contact {
namespace {

/// What one look at an iterate tells, the same on every rank.
struct Judgement {
  double residual = 0;   ///< max H |step of length 1| beyond a row's noise [velocity]
  double energy = 0;     ///< max H |step of length 1|^2, the size of the terms of the next quotient [energy]
  double impulse = 0;    ///< bound of what p gives to a node
  double rise = 0;       ///< bound of what a step of length 1 can add to it
  bool coupled = false;  ///< rows share nodes: else a step of length 1 is exact
  double speed = 0;      ///< largest component of a slave's velocity
  double change_h_change = 0, change_a_change = 0, a_change_a_change = 0;  ///< s.Hs, s.As, As.H^-1 As
};

class Iteration {
 public:
  Iteration(const System& system, bool coupled, Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
            EnforcementScratch& scratch)
      : system_(system),
        coupled_(coupled),
        exchange_(exchange),
        impulses_(impulses),
        velocity_(velocity),
        scratch_(scratch) {
    scratch.packed.lay(system.rows, scratch.diagonal, scratch.compliance, scratch.borne, impulses);
    take_velocities();
  }

  /// term_size: bound of the terms of s.Hs; 0 for the first iterate, which has no change.
  Judgement judge(double term_size);
  /// p and v of the next iterate.
  void advance(const Judgement& now, double length);
  /// Begins again from nothing.
  void reset();

 private:
  void take_velocities() { scratch_.packed.take_velocities(velocity_.first(system_.motion.size())); }

  const System& system_;
  bool coupled_;
  Exchange& exchange_;
  std::span<Vec3> impulses_, velocity_;
  EnforcementScratch& scratch_;
};

Judgement Iteration::judge(double term_size) {
  const FixedUnit unit(term_size);
  const RowsSeen here = scratch_.packed.judge(system_.rows, term_size > 0 ? &unit : nullptr);
  std::array<double, 6> largest{here.residual, here.energy, here.impulse, here.rise, coupled_ ? 1.0 : 0.0, here.speed};
  std::array<std::int64_t, 3> sums{here.change_h_change, here.change_a_change, here.a_change_a_change};
  exchange_.reduce(largest, sums);
  demand_finite(largest[0] + largest[2]);
  return {largest[0], largest[1],          largest[2],          largest[3],         largest[4] > 0,
          largest[5], unit.value(sums[0]), unit.value(sums[1]), unit.value(sums[2])};
}

void Iteration::advance(const Judgement& now, double length) {
  scratch_.packed.advance(length, impulses_);
  apply_impulses(system_, impulses_, now.impulse + length * now.rise, exchange_, velocity_, scratch_);
  take_velocities();
}

void Iteration::reset() {
  std::ranges::fill(impulses_, Vec3::Zero());
  scratch_.packed.reset();
  take_prediction(system_, velocity_);
  take_velocities();
}

/// At least 1, since H bounds G W G^T. The choice between the two quotients has no period (steps of the golden section
/// around a circle): strict alternation may lead to a cycle of four steps.
double quotient(const Judgement& now, int iteration) {
  constexpr double longest = 1e6;
  constexpr double golden_section = 0.6180339887498949;
  const bool long_one = std::fmod(golden_section * iteration, 1) < 0.5;
  const double length =
      long_one ? now.change_h_change / now.change_a_change : now.change_a_change / now.a_change_a_change;
  return length >= 1 ? std::min(length, longest) : 1.0;  // also where nothing is left to divide
}

/// v = v*, and what all ranks are to know, in one message.
Setting look_at_rows(const System& system, bool warm_start, Exchange& exchange, std::span<const Vec3> impulses,
                     std::span<Vec3> velocity) {
  take_prediction(system, velocity);
  double share = 1, rubs = 0, holds = 0, friction = 0, lagging = 0;
  for (const RowLaw& law : system.rows.laws) {
    share = std::max(share, law.share);
    if (law.across == Across::rubs || law.lagging > 0) rubs = 1;
    friction = std::max(friction, law.friction);
    lagging = std::max(lagging, law.lagging);
    if (law.across == Across::holds) holds = 1;
  }
  std::array<double, 7> largest{violation_here(system, velocity),
                                warm_start ? largest_impulse_on_a_node(system.rows, impulses) : 0.0,
                                share,
                                rubs,
                                holds,
                                friction,
                                lagging};
  exchange.max(largest);
  return {.violation = largest[0],
          .impulse = largest[1],
          .share = largest[2],
          .friction = largest[5],
          .lagging = largest[6],
          .rubs = largest[3] > 0,
          .holds = largest[4] > 0};
}

/// Barzilai-Borwein steps go on from where conjugate residuals have come to, or from nothing where that is nearer.
EnforcementResult conjugate_or_quotients(const System& system, const EnforcementSettings& settings,
                                         const Setting& setting, bool coupled, Exchange& exchange,
                                         std::span<Vec3> impulses, std::span<Vec3> velocity,
                                         EnforcementScratch& scratch) {
  EnforcementSettings part = settings;
  part.max_iterations = setting.rubs ? (3 * settings.max_iterations + 3) / 4 : (settings.max_iterations + 1) / 2;
  const EnforcementResult first =
      iterate_conjugate(system, part, setting, coupled, exchange, impulses, velocity, scratch);
  if (first.iterations < part.max_iterations || first.residual <= settings.tolerance) return first;
  if (!(first.residual < 1)) {
    std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
    take_prediction(system, velocity);
  }
  EnforcementSettings rest = settings;
  rest.warm_start = false;
  rest.max_iterations -= first.iterations;
  EnforcementResult result =
      iterate(system, rest, StepLength::longer, true, setting.violation, exchange, impulses, velocity, scratch);
  result.iterations += first.iterations;
  return result;
}

}  // namespace

double residual_to_reach(const System& system, const EnforcementSettings& settings, double first) {
  const double gained = system.carriers.bodies.empty() ? 0.03 : 0.001;  // of a warm start's residual
  constexpr double still = 1e-8;                                        // of the tolerance
  if (!settings.warm_start) return settings.tolerance;
  return std::min(settings.tolerance, std::max(gained * first, still * settings.tolerance));
}

EnforcementResult iterate(const System& system, const EnforcementSettings& settings, StepLength length, bool coupled,
                          double violation, Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                          EnforcementScratch& scratch) {
  EnforcementResult result{.violation = violation};
  Iteration iteration(system, coupled, exchange, impulses, velocity, scratch);
  const bool quotients = length == StepLength::longer;
  constexpr double long_steps_share = 0.75;  // of the iterations, where they do not descend
  Stall stall(30);                           // Barzilai-Borwein steps do not descend one by one
  double enough = settings.tolerance;
  double taken = 1, terms = 0;
  int sweeps = 0;  // that come next
  bool sweeps_only = false;
  while (true) {
    const Judgement now = iteration.judge(terms);
    result.residual = now.residual / violation;
    if (!now.coupled && settings.max_iterations > 0) {
      iteration.advance(now, 1);
      return {violation, 0.0, 1, true};
    }
    const bool rounding = now.residual <= rounding_share * now.speed;  // of velocities: nothing is left to gain
    if (result.iterations == 0) enough = residual_to_reach(system, settings, result.residual);
    if (result.residual <= enough || rounding || result.iterations == settings.max_iterations) {
      const bool sweep = taken > 1 || (result.iterations == 0 && !rounding);
      if (sweep) iteration.advance(now, 1);
      result.acted = now.impulse > 0 || sweep;
      return result;
    }
    if (const int due = stall.sweeps_due(result.iterations, result.residual); due > 0 && !sweeps_only) {
      sweeps_only = result.iterations >= long_steps_share * settings.max_iterations;
      sweeps = sweeps_only ? settings.max_iterations : due;
      if (sweeps_only && !(result.residual < 1)) {  // farther off than no impulse at all
        iteration.reset();
        terms = 0;
        continue;
      }
    }
    taken = quotients && result.iterations > 0 && sweeps == 0 ? quotient(now, result.iterations) : 1.0;
    sweeps = std::max(sweeps - 1, 0);
    iteration.advance(now, taken);
    terms = quotients ? taken * taken * now.energy : 0.0;
    ++result.iterations;
  }
}

EnforcementResult enforce_rate_constraint(const System& system, const EnforcementSettings& settings, StepLength length,
                                          Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                          EnforcementScratch& scratch) {
  const Setting setting = look_at_rows(system, settings.warm_start, exchange, impulses, velocity);
  if (setting.violation == 0 || !settings.warm_start) std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
  if (setting.violation == 0) return {};
  const bool coupled = setting.impulse > 0
                           ? start_from_impulses(system, impulses, setting.impulse, exchange, velocity, scratch)
                           : form_row_sums(system, exchange, scratch);
  soften(system, impulses, velocity, exchange, scratch);
  const bool conjugate = length == StepLength::longer && (!setting.rubs || !system.carriers.bodies.empty());
  EnforcementResult result =
      conjugate ? conjugate_or_quotients(system, settings, setting, coupled, exchange, impulses, velocity, scratch)
                : iterate(system, settings, length, coupled, setting.violation, exchange, impulses, velocity, scratch);
  if (ended_at_limit(result, settings)) guard_energy(system, exchange, impulses, velocity, scratch, result);
  return result;
}

}  // namespace brunt::contact
