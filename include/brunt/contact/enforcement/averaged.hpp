// SPDX-License-Identifier: Apache-2.0
// The mean of two passes, each solved by the method chosen from the same v*: half the impulse of each row of one pass,
// of rows of both the mean of their two (beta = 1/2 of Heinstein et al. 2000, eq. (24)). Since the kinetic energy is
// convex the mean has no more than the passes, and what holds in both of them holds in the mean. For methods that let
// gaps be closed by later steps; those that hold rates solve both passes' rows as one system: see contact/passes.hpp.
#pragma once
#include "brunt/contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`. iterations: of the slower pass; residual: of the worse.
EnforcementResult enforce_averaged(const System& system, const EnforcementSettings& settings, double dt,
                                   Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                   EnforcementScratch& scratch);

}  // namespace brunt::contact
