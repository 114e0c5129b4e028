// SPDX-License-Identifier: Apache-2.0
// The mean of two passes, each solved by the chosen method from the same v*: half the impulse of each row of one pass,
// and the mean of both for rows of both passes (beta = 1/2 of Heinstein et al. 2000, eq. (24)). Since the kinetic
// energy is convex, the mean has no more energy than the passes, and conditions satisfied by both passes hold for the
// mean. The approach that the mean leaves, since the passes disagree, is added to the required rates, and both passes
// are solved once more, in place of the corrector (25). Used for methods that close gaps over several steps, and on
// request (Passes::averaged); other methods solve the rows of both passes as one system: see surface/passes.hpp.
#pragma once
#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`. iterations: of the slower pass, both solutions together; residual: the larger one.
EnforcementResult enforce_averaged(const System& system, const EnforcementSettings& settings, double dt,
                                   Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                   EnforcementScratch& scratch);

/// The required rate of a row of one pass in the second solution [velocity], at least `required`. predicted, averaged:
/// its rates by v* and by the mean of the first solution [velocity].
/// - Its own pass satisfied `required`, so the other pass missed it by 2 (required - averaged). Requiring this excess
/// makes the mean satisfy it. Gaps are thus held as by one pass, even if only one of the passes detects the contact,
/// and without a jump when a gap closes (a rule for closed gaps only makes bodies at rest oscillate between steps).
/// - At most the rate of approach by v*, so that an impulse p does the work p (predicted + asked) / 2 <= 0 and the
/// correction supplies no energy.
double asked_back(double required, double predicted, double averaged);

}  // namespace brunt::contact
