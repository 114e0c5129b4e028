// SPDX-License-Identifier: Apache-2.0
// Initial velocities that a tie cannot satisfy. Ties are equations of positions: with the trapezoidal rule a difference
// of velocities across a seam is conserved and changes its sign in every step.
#pragma once
#include <string>
#include <vector>

#include "implicit/solver.hpp"

namespace brunt::implicit {

/// A warning for each tie whose sides have different velocities at the start. The same on all ranks. Collective.
std::vector<std::string> warnings_of_tied_velocities(const Scene& scene, const Solver& solver,
                                                     const std::string& velocity_unit);

}  // namespace brunt::implicit
