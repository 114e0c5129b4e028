// SPDX-License-Identifier: Apache-2.0
// Compliant rows: they yield to a change of their impulse. A rigid row requires normal . r >= required, a compliant one
//   normal . r + C (p - p_before) >= required - kappa C p_before,
// and likewise across the normal when it sticks. This is a proximal term (Rockafellar, SIAM J. Control Optim. 14, 1976)
// from step to step: the system has the matrix G W G^T + C, whose eigenvalues are at least C. As a contact law it is a
// massless spring without a bound on the step: under a force f the penetration of the slave is C f dt^2. The last term
// makes it conservative: recovery takes back the share kappa of a penetration in each step. If it also recovered the
// part of the spring under load, contact would do work at every change of the load. With this term it does none, for
// any history of the load: it returns the energy that it stored.
//
// Rows of two passes (C = s / mass of the slave) are compliant if the scene requests it: this raises the small
// eigenvalues of G W G^T, so that fine meshes need as many iterations as coarse ones, at the cost of an error of
// uniform pressure (table in cases/README.md, "Softness of contact").
//
// Rows between rigid bodies are compliant by default: they far outnumber the degrees of freedom of the bodies, their
// gaps and drifts are compatible with no rigid motion to the last digit, and the impulses of rigid rows would grow
// against each other with time until some slide. A load on a light body between heavy ones passes through both of its
// interfaces, so their compliance must be small against what the heavy bodies answer; with that of the light body it
// would be a spring. C = s n . G W G^T n times a factor up to 1 that follows from the chain of bodies
// (src/contact/enforcement/chains.hpp); with equal bodies it is 1.
//
// Bodies that collide must not be thrown back by what the rows yielded in the impact. The rows of a chain therefore
// keep only the share of their last impulses that this step needs: p_before = theta (last p), with theta in [0, 1] the
// minimiser of the energy along the last impulses,
//   theta = sum p . (required - n . r*) / sum p . (n . G W G^T p)    (p of the last step, along the normals).
// At rest theta is 1, and after an impact 0. The rest of the stored energy is lost.
//
// No law of springs and dashpots can yield to a change of the load and not to a constant load: the compliance J, the
// depth under a unit load as a function of frequency, does not decrease towards low frequencies, so J(0) = 0 implies J
// = 0. Recovery of the depth under load supplies its work (tables in cases/README.md, "Softness of contact").
#pragma once
#include <span>

#include "contact/enforcement/system.hpp"

namespace brunt::contact {

/// From scratch.diagonal, which is increased for compliant rows, and the impulses of the last step, one for each row:
/// fills scratch.compliance and scratch.borne. velocity: v* + W G^T of these impulses. Collective.
void soften(const System& system, std::span<const Vec3> before, std::span<const Vec3> velocity, Exchange& exchange,
            EnforcementScratch& scratch);

}  // namespace brunt::contact
