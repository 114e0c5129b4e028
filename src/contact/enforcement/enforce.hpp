// SPDX-License-Identifier: Apache-2.0
// The common interface of all enforcement methods: rows in, impulses and velocities out.
#pragma once
#include <span>

#include "contact/data/options.hpp"
#include "contact/enforcement/system.hpp"

namespace brunt::contact {

struct EnforcementResult {
  double violation = 0;  ///< largest shortfall max(0, required - G v*) [velocity]; 0: nothing to do
  double residual = 0;   ///< natural residual max_q H_q |p_q - admitted(p_q + missing_q / H_q)| relative to violation,
                         ///< of the last iterate that was judged
  int iterations = 0;
  bool acted = false;              ///< impulses changed v*; otherwise the velocity is unchanged
  GlobalIndex scaled_islands = 0;  ///< of a step that ended early: islands whose impulses were scaled, energy_guard.hpp
  double least_share = 1;          ///< of their impulses that one of them kept
};

/// Whether the iteration ended at max_iterations without reaching its tolerance. Always false for methods without
/// iteration.
inline bool ended_at_limit(const EnforcementResult& result, const EnforcementSettings& settings) {
  return result.iterations >= settings.max_iterations && result.residual > settings.tolerance;
}

/// Collective. impulses: in, the start (zero, or those of the last step); out, p [momentum], one for each row.
/// velocity: out, v on every contact node, the same bits on every copy; equal to v* if nothing acts. dt [time]: of the
/// coming step. Throws GuardError if an impulse is not finite.
EnforcementResult enforce(const System& system, const EnforcementSettings& settings, double dt, Exchange& exchange,
                          std::span<Vec3> impulses, std::span<Vec3> velocity, EnforcementScratch& scratch);

/// Factor of the stable step of the elements: penalties are additional springs.
double step_factor(const EnforcementSettings& settings);

}  // namespace brunt::contact
