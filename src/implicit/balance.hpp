// SPDX-License-Identifier: Apache-2.0
// The forces of a trial step and their residual.
#pragma once
#include <span>

#include "implicit/solver.hpp"

namespace brunt::implicit {

/// Sets nodes to X + u, with the mean velocities since t_n, and computes internal forces, trial histories and loads at
/// t_{n+1}. `u`: of Unknowns::node. Returns false if an element has no positive volume there. Collective.
bool find_forces(const Scene& scene, Solver& solver, std::span<const double> u);

/// The part of it that regards the elements: nodes at X + displacement (of all nodes of this rank, three each).
/// Collective.
bool find_element_forces(const Scene& scene, Solver& solver, std::span<const double> displacement);

/// After find_forces: the residual of the equation of motion along free directions, and along constrained ones
/// support_stiffness times the missing part of the prescribed displacement; sets Trial::balance. Collective.
void balance(const Scene& scene, Solver& solver, std::span<double> residual);

/// Derivative of the residual with respect to u at the iterate: Solver::rows. With FrictionLimit::given the symmetric
/// part decides about stability; the terms of supports of rigid bodies are then left out. Collective.
void assemble_tangent(const Scene& scene, Solver& solver, FrictionLimit limit);

/// The same with FrictionLimit::follows, factorised. Collective.
comm::Factorised factorise_tangent(const Scene& scene, Solver& solver);

/// Prescribed values of supports and drives for the next step: Trial::given, given_velocity.
void prescribe(const Scene& scene, Trial& trial);

}  // namespace brunt::implicit
