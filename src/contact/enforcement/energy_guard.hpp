// SPDX-License-Identifier: Apache-2.0
// The guard of a step whose iteration ended early. Contact gives no energy: for the impulses theta p of an island,
//   E(theta) = sum of theta p . (r* - r_wall) + theta^2/2 p . (r - r*)    kinetic energy, r* by v*, r by v* + W G^T p
//            + sum of theta^2/2 C |p|^2 - 1/2 C |p'|^2                    stored by compliant rows, and before
//            - sum of theta max(0, p . target)                            work of recovery
// must not exceed zero. p' is the part of the impulse before the step that softness keeps (C p' = borne), r_wall the
// velocity of a moving wall; r is relative, so the work of prescribed motion does not count either. target: the rate
// that recovers penetration or slip, along and across the normal; a row that approaches has none. At the solution of
// the step p . (r + C p - C p') <= p . target, so E <= -1/2 p . (r - r*) < 0, and nothing is scaled. E is quadratic and
// convex in theta and E(0) <= 0, so each island keeps the largest share theta in [0, 1] with E(theta) <= 0. Scaled
// impulses remain admissible (cones are convex and contain 0), and momentum is kept, since each row's impulses cancel.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/enforcement/enforce.hpp"
#include "contact/enforcement/islands.hpp"

namespace brunt::contact {

/// Scales the impulses of islands that would gain energy, computes the velocities again if there are any, and counts
/// them in `result`. velocity: v* + W G^T p. Exact sums, so no bit depends on the ranks. It allocates memory: only for
/// steps that ended early. Collective.
void guard_energy(const System& system, Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                  EnforcementScratch& scratch, EnforcementResult& result);

/// The largest theta in [0, 1] with linear theta + quadratic theta^2 / 2 <= stored, for quadratic, stored >= 0.
double share_without_gain(double linear, double quadratic, double stored);

}  // namespace brunt::contact
