// SPDX-License-Identifier: Apache-2.0
// The energy balance at t_n of an implicit run. The work of each force in a step is the mean of its values at both ends
// times the displacement, so that with the trapezoidal rule the total is an identity up to the residual of Newton's
// iteration.
#pragma once
#include "implicit/solver.hpp"
#include "time/ledger.hpp"

namespace brunt::implicit {

/// After a step, or at t = 0. Static states have neither kinetic energy nor momentum. Collective.
time::Ledger ledger(const Scene& scene, const Solver& solver);

}  // namespace brunt::implicit
