// SPDX-License-Identifier: Apache-2.0
// The forces of a trial step, and what of them is left over.
#pragma once
#include <span>

#include "brunt/implicit/solver.hpp"

namespace brunt::implicit {

/// Puts nodes at X + u, with the mean velocities since t_n, and finds internal forces, trial histories and loads at
/// t_{n+1}. `u`: of Unknowns::node. False: some element has no volume left there. Collective.
bool find_forces(const Scene& scene, Solver& solver, std::span<const double> u);

/// After find_forces: the residual of the step's equation along free directions, and along held ones
/// support_stiffness times what is missing of the given travel; sets Trial::balance. Collective.
void balance(const Scene& scene, Solver& solver, std::span<double> residual);

/// Derivative of the residual by u at the iterate, factorised. Collective.
comm::Factorised factorise_tangent(const Scene& scene, Solver& solver);

/// What supports and drives give for the step to come: Trial::given, given_velocity.
void prescribe(const Scene& scene, Trial& trial);

}  // namespace brunt::implicit
