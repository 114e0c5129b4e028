// SPDX-License-Identifier: Apache-2.0
// The linear system of an implicit step, whole and dense, against differences of its residual.
#pragma once
#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <vector>

#include "implicit/balance.hpp"

namespace brunt::test {

inline Eigen::MatrixXd dense(const comm::SparseRows& rows) {
  const auto n = static_cast<Eigen::Index>(rows.row.size());  // of one rank: all of them
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t r = 0; r < rows.row.size(); ++r)
    for (std::int64_t k = rows.begin[r]; k < rows.begin[r + 1]; ++k)
      K(rows.row[r], rows.column[static_cast<std::size_t>(k)]) = rows.value[static_cast<std::size_t>(k)];
  return K;
}

inline Eigen::VectorXd residual_at(const implicit::Scene& scene, implicit::Solver& solver,
                                   const std::vector<double>& u) {
  Eigen::VectorXd r(static_cast<Eigen::Index>(u.size()));
  REQUIRE(implicit::find_forces(scene, solver, u));
  implicit::balance(scene, solver, {r.data(), u.size()});
  return r;
}

/// Largest entry of the tangent at Solver::u off from central differences, over its largest entry. step_of: the step
/// of the difference in each unknown.
inline double tangent_error(const implicit::Scene& scene, implicit::Solver& solver,
                            const std::function<double(std::size_t)>& step_of) {
  (void)residual_at(scene, solver, solver.u);
  REQUIRE(implicit::factorise_tangent(scene, solver).ok());
  const Eigen::MatrixXd K = dense(solver.rows);
  double worst = 0;
  for (std::size_t c = 0; c < solver.u.size(); ++c) {
    const double h = step_of(c);
    std::vector<double> ahead = solver.u, behind = solver.u;
    ahead[c] += h;
    behind[c] -= h;
    const Eigen::VectorXd slope = (residual_at(scene, solver, ahead) - residual_at(scene, solver, behind)) / (2 * h);
    worst = std::max(worst, (slope - K.col(static_cast<Eigen::Index>(c))).lpNorm<Eigen::Infinity>());
  }
  return worst / K.lpNorm<Eigen::Infinity>();
}

}  // namespace brunt::test
