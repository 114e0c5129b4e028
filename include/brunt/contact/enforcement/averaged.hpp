// SPDX-License-Identifier: Apache-2.0
// The mean of two passes, each solved by the method chosen from the same v*: half the impulse of each row of one pass,
// of rows of both the mean of their two. Since the kinetic energy is convex the mean has no more than the passes, and
// what holds in both of them holds in the mean.
#pragma once
#include "brunt/contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`. iterations, residual: of the slower, the worse pass.
EnforcementResult enforce_averaged(const System& system, const EnforcementSettings& settings, double dt,
                                   Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                   EnforcementScratch& scratch);

}  // namespace brunt::contact
