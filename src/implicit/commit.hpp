// SPDX-License-Identifier: Apache-2.0
// The beginning and the end of a step: from t_n to a trial, and from the trial to t_{n+1} or back.
#pragma once
#include "implicit/solver.hpp"

namespace brunt::implicit {

/// Fills Trial for a step to `time` of length `dt` and Solver::u with the first iterate.
void begin_step(const Scene& scene, Solver& solver, double dt, double time);

/// The trial becomes the state of t_{n+1}: histories, displacements, velocities, works by the trapezoidal rule.
void commit_step(const Scene& scene, Solver& solver);

/// Restores the state of t_n.
void give_back(const Scene& scene, Solver& solver);

}  // namespace brunt::implicit
