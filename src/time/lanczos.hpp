// SPDX-License-Identifier: Apache-2.0
// The largest frequency of a mesh of linear elements, from below.
#pragma once
#include <limits>
#include <vector>

#include "force/assembled.hpp"
#include "model/model.hpp"
#include "time/links.hpp"

namespace brunt::time {

/// Largest eigenvalue of a symmetric tridiagonal matrix with eigenvalues in [0, 2], to 1e-12.
double largest_of_tridiagonal(const std::vector<double>& diagonal, const std::vector<double>& beside);

/// The largest eigenvalue of (inverse mass times stiffness)/scale found by this number of Lanczos products from a
/// random motion: a lower bound of the true one. `scale` is an upper bound of it. The motion follows from global node
/// numbers and the step, and sums are exact: the same bits on any number of ranks. Ends early if `enough` is reached.
/// Collective.
double largest_eigenvalue(const model::Model& model, const model::State& state, Links& links,
                          const force::LinearElements& linear, double scale, int products,
                          double enough = std::numeric_limits<double>::infinity());

}  // namespace brunt::time
