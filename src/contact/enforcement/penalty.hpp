// SPDX-License-Identifier: Apache-2.0
// Penalties of Heinstein et al. 2000: a spring across penetrations, eq. (16), and a spring and a damper, eq. (20).
// Explicit: one sweep, no iteration. The spring of a row is `stiffness` / (H dt^2) with H the row sums, so that all
// springs together raise the square of the highest frequency by at most stiffness / dt^2 (Gershgorin).
#pragma once
#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`. damping: settings.damping, or 0 for eq. (16). Rows with a free cone are constraints and hold exactly.
EnforcementResult enforce_penalty(const System& system, const EnforcementSettings& settings, double damping, double dt,
                                  Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                  EnforcementScratch& scratch);

}  // namespace brunt::contact
