// SPDX-License-Identifier: Apache-2.0
// One implicit step, THE page: predict, Newton's iteration, commit; with shorter steps where the iteration fails.
//
//   u = u* = u_n + dt v_n                                  predict; what supports give at t_{n+1}
//   until the forces left over are small against those that act:
//     r(u) = m M (u - u*) - now F(u) - before F_n          out of balance: elements, loads, inertia, supports
//     u -= K^-1 r,  K = dr/du                              consistent tangent, sparse direct solution
//   histories, velocities, accounts of work                commit
//
// All nodes, histories and accounts are those of t_n between steps; no half steps.
#pragma once
#include <functional>
#include <string>

#include "brunt/implicit/solver.hpp"

namespace brunt::implicit {

constexpr int most_iterations = 20;  ///< three times those of a hard step that succeeds; then a shorter one is cheaper

/// From t_n to t_{n+1}. Throws GuardError where no step down to min_step converges or a body floats that nothing
/// holds: then the state is that of t_n. `place` tells the node of a message. Collective.
void advance(const Scene& scene, Solver& solver, const std::function<std::string(GlobalIndex gid)>& place);

}  // namespace brunt::implicit
