// SPDX-License-Identifier: Apache-2.0
// Where the energy is at t_n of an implicit run. Works are those of the mean of the forces at both ends of each step on
// its travel, so that with the trapezoidal rule the total is an identity up to what Newton's iteration has left.
#pragma once
#include "brunt/implicit/solver.hpp"
#include "brunt/time/ledger.hpp"

namespace brunt::implicit {

/// After a step, or at the start. Static states have neither kinetic energy nor momentum. Collective.
time::Ledger ledger(const Scene& scene, const Solver& solver);

}  // namespace brunt::implicit
