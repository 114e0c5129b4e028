// SPDX-License-Identifier: Apache-2.0
// The door to all ways of enforcing contact: rows in, impulses and velocities out.
#pragma once
#include <span>

#include "brunt/contact/data/options.hpp"
#include "brunt/contact/enforcement/system.hpp"

namespace brunt::contact {

struct EnforcementResult {
  double violation = 0;  ///< largest shortfall max(0, required - G v*) [velocity]; 0: nothing to do
  double residual = 0;   ///< natural residual max_q H_q |p_q - admitted(p_q + missing_q / H_q)| relative to violation,
                         ///< of the last iterate that was judged
  int iterations = 0;
  bool acted = false;  ///< impulses changed v*: else velocity is what it was
};

/// Did the iteration stop at max_iterations, short of its tolerance? Methods that do not iterate never do.
inline bool ended_at_limit(const EnforcementResult& result, const EnforcementSettings& settings) {
  return result.iterations >= settings.max_iterations && result.residual > settings.tolerance;
}

/// Collective. impulses: in, the start (zero, or those of the last step); out, p [momentum], a row each. velocity: out,
/// v on every contact node, the same bits on every copy; equal to v* where nothing acts. dt [time]: of the step ahead.
/// Throws GuardError where an impulse is not finite.
EnforcementResult enforce(const System& system, const EnforcementSettings& settings, double dt, Exchange& exchange,
                          std::span<Vec3> impulses, std::span<Vec3> velocity, EnforcementScratch& scratch);

/// What the stable step of the elements is to be multiplied by: penalties are springs of their own.
double step_factor(const EnforcementSettings& settings);

}  // namespace brunt::contact
