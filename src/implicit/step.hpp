// SPDX-License-Identifier: Apache-2.0
// One implicit step: predictor, Newton's iteration, commit; with shorter steps if the iteration fails.
//
//   u = u* = u_n + dt v_n                                  predictor; prescribed values of supports at t_{n+1}
//   until the residual is small compared to the applied forces:
//     r(u) = m M (u - u*) - now F(u) - before F_n          residual: elements, loads, inertia, supports
//     u -= K^-1 r,  K = dr/du                              consistent tangent, sparse direct solution
//   histories, velocities, accounts of work                commit
//
// All nodes, histories and accounts are those of t_n between steps; no half steps.
#pragma once
#include <functional>
#include <string>

#include "implicit/solver.hpp"

namespace brunt::implicit {

constexpr int most_iterations = 20;  ///< three times those of a difficult step that converges

/// From t_n to t_{n+1}. Throws GuardError if no step down to min_step converges or a body has an unconstrained rigid
/// motion: the state is then that of t_n. `place` describes the location of a node in a message. `objection`, of the
/// positions of a converged step: why it must be shorter, or empty; the same on all ranks; none where absent.
/// Collective.
void advance(const Scene& scene, Solver& solver, const std::function<std::string(GlobalIndex gid)>& place,
             const std::function<std::string()>& objection = {});

/// Assembles and factorises the first iteration of the next step, as `advance` would, and returns to t_n without a
/// solution: what an iteration costs. Collective.
[[nodiscard]] comm::Factorised factorise_first(const Scene& scene, Solver& solver);

}  // namespace brunt::implicit
