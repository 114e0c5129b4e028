// SPDX-License-Identifier: Apache-2.0
// Rows that give way to a change of their impulse. Where a rigid row asks for normal . r >= required, a soft one asks
// for
//   normal . r + C (p - p_before) >= required - kappa C p_before,   C = s / mass of the slave,
// and likewise across the normal where it sticks: a proximal term (Rockafellar, SIAM J. Control Optim. 14, 1976) that
// goes from step to step, so that G W G^T + C is solved with, whose eigenvalues are C and more. As a law of contact it
// is a spring without mass, and without a bound on the step: under a force f the slave lies C f dt^2 deep. The last
// term makes it one. Recovery takes back the share kappa of a penetration in each step; were the spring's part of it
// taken back too, under load, contact would do work at every turn of the load: 3e-3 to 2e-2 of what two blocks store
// when pressed six times (s = 0.1). With the term it does none, however the load comes and goes: it returns what it
// stored.
// Soft are rows between rigid bodies (C = s n . G W G^T n): these are far more than the bodies have freedom, their gaps
// and drifts fit no motion of the bodies to the last digit, and rigid ones would brace against each other the more the
// longer they last, until some slide. Rows of two passes are soft where the scene asks for it: this lifts the weak end
// of G W G^T, and fine meshes take as many iterations as coarse ones, but even pressure errs by 1 to 2.4 % (s = 0.05).
// No law of springs and dashpots gives way to a change of the load and not to the load that stays: J, the depth under a
// unit of load by frequency, does not fall towards low ones, so J(0) = 0 leaves J = 0 for all. What takes back the
// depth under load gives the work of it (tables in cases/README.md, "Softness of contact").
#pragma once
#include <span>

#include "brunt/contact/enforcement/system.hpp"

namespace brunt::contact {

/// From scratch.diagonal, which it raises for soft rows, and the impulses of the last step, a row each: fills
/// scratch.compliance and scratch.borne.
void soften(const System& system, std::span<const Vec3> before, EnforcementScratch& scratch);

}  // namespace brunt::contact
