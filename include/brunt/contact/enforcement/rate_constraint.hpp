// SPDX-License-Identifier: Apache-2.0
// The iterative rate constraint of Heinstein et al. 2000, eq. (26), for unilateral contact: impulses lambda >= 0 such
// that G v >= required with v = v* + W G^T lambda, and lambda = 0 where the inequality is strict. Projected Jacobi:
// every row is updated from the previous iterate with the row-sum diagonal
//   H_q = sum_n |G_qn P_n| s_n / m_n,   s_n = sum_p |G_pn P_n|,
// P_n the node's projector, in place of the paper's eq. (29). H - G W G^T is positive semidefinite by Gershgorin, so
// the iteration descends monotonically for any masses and meshes, and stopped early it never gives energy.
#pragma once
#include <span>
#include <vector>

#include "brunt/contact/constraint.hpp"
#include "brunt/contact/exchange.hpp"

namespace brunt::contact {

struct RateSettings {
  double tolerance = 1e-3;  ///< of the residual, relative to the largest violation by the predicted velocities
  int max_iterations = 50;
};

struct RateResult {
  double violation = 0;  ///< largest shortfall max(0, required - G v*) [velocity]; 0: nothing to do
  double residual = 0;   ///< natural residual max_q H_q |lambda_q - proj(lambda_q + (required - G v)_q / H_q)|
                         ///< relative to violation, of the last iterate that was judged
  int iterations = 0;
  bool acted = false;  ///< impulses changed v*: else velocity is what it was
};

/// Arrays of the solver, sized where lists are rebuilt so that a step allocates nothing.
struct RateScratch {
  std::vector<double> diagonal;       ///< H, a row each
  std::vector<double> next;           ///< impulses of the next iterate, a row each
  std::vector<double> row_sum;        ///< s, a node each
  std::vector<double> row_sum_parts;  ///< two slices and the number of rows, a node each
  std::vector<double> impulse_parts;  ///< three components of two slices, a node each

  void reserve(std::size_t rows, std::size_t nodes);
};

/// Collective. motion, mobility: of all contact nodes of this rank. impulses: in, the start (zero, or those of the last
/// step); out, lambda [momentum]. velocity: out, v on every contact node, the same bits on every copy; equal to v*
/// where nothing acts. Throws GuardError where an impulse is not finite.
RateResult enforce_rate_constraint(std::span<const Row> rows, std::span<const NodeMotion> motion,
                                   std::span<const Mobility> mobility, const RateSettings& settings, Exchange& exchange,
                                   std::span<double> impulses, std::span<Vec3> velocity, RateScratch& scratch);

}  // namespace brunt::contact
