// SPDX-License-Identifier: Apache-2.0
// The mean of two passes, each solved by the method chosen from the same v*: half the impulse of each row of one pass,
// of rows of both the mean of their two (beta = 1/2 of Heinstein et al. 2000, eq. (24)). Since the kinetic energy is
// convex the mean has no more than the passes, and what holds in both of them holds in the mean. What the mean leaves
// of an approach, since the passes disagree, is asked back, and both passes are solved once more: in the place of the
// corrector (25). For methods that let gaps be closed by later steps, and where a scene asks for it (Passes::averaged);
// others solve both passes' rows as one system: see contact/passes.hpp.
#pragma once
#include "brunt/contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`. iterations: of the slower pass, both solutions together; residual: of the worst.
EnforcementResult enforce_averaged(const System& system, const EnforcementSettings& settings, double dt,
                                   Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                   EnforcementScratch& scratch);

/// What a row of one pass asks for in the second solution [velocity], `required` or more. predicted, averaged: its
/// rates by v* and by the mean of the first solution [velocity].
/// - Its own pass met `required`, so the other pass missed it by 2 (required - averaged): as much makes the mean meet
///   it. That holds gaps as one pass does, also where only one of the passes sees that the bodies meet, and without a
///   jump where a gap closes (a rule for closed gaps alone makes bodies at rest flicker from step to step).
/// - No more than the rate at which the bodies come together by v*, so that an impulse p does the work
///   p (predicted + asked) / 2 <= 0 and the feedback gives no energy.
double asked_back(double required, double predicted, double averaged);

}  // namespace brunt::contact
