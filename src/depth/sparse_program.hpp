// SPDX-License-Identifier: Apache-2.0
// Strictly convex quadratic programs in any number of unknowns with rows of few coefficients,
//   minimise 1/2 x^T G x + g^T x   subject to   n_i . x >= b_i,
// by the dual active-set method of Goldfarb and Idnani, as in quadratic_program.hpp for a fixed number of unknowns. A
// step costs O(n^2), the choice of the most violated row O(12 rows).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"
#include "depth/quadratic_program.hpp"

namespace brunt::depth {

/// A row of at most twelve coefficients: the number of unknowns of two rigid bodies.
struct SparseRow {
  std::array<int, 12> place{};     ///< unknowns, each once
  std::array<double, 12> value{};  ///< their coefficients
  int count = 0;
  double bound = 0;

  void add(int unknown, double coefficient) {
    nth(place, count) = unknown;
    nth(value, count++) = coefficient;
  }
  /// n . x of a vector of all unknowns
  [[nodiscard]] double times(const double* x) const {
    double sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) sum += value[i] * x[place[i]];
    return sum;
  }
  [[nodiscard]] double norm() const;
};

class SparseProgram {
 public:
  /// G: n x n, row by row, symmetric and positive definite; g: n entries. The active set is empty.
  SparseProgram(std::span<const double> G, std::span<const double> g);

  /// Rows of earlier calls must come first and unchanged. A row counts as satisfied if n . x >= b - tolerance |n|.
  Outcome solve(std::span<const SparseRow> rows, double tolerance);

  [[nodiscard]] const std::vector<double>& x() const { return x_; }
  /// 1/2 x^T G x + g^T x
  [[nodiscard]] double value() const;
  /// Indices of the active rows; if infeasible, followed by the last row of the proof.
  [[nodiscard]] std::span<const int> active() const {
    return {active_.data(), static_cast<std::size_t>(count_ + proof_)};
  }
  /// As QuadraticProgram::weights: multipliers, or a proof of infeasibility.
  [[nodiscard]] std::span<const double> weights() const {
    return {weights_.data(), static_cast<std::size_t>(count_ + proof_)};
  }

 private:
  [[nodiscard]] int most_violated(std::span<const SparseRow> rows, double tolerance) const;
  Outcome enter(std::span<const SparseRow> rows, int entering);
  void add();
  void drop(int place);
  double* column(int k) { return J_.data() + static_cast<std::size_t>(k) * x_.size(); }
  double& R(int i, int k) { return R_[static_cast<std::size_t>(k) * x_.size() + static_cast<std::size_t>(i)]; }
  void rotate(int k, double c, double s);

  std::vector<double> G_, g_, x_;
  std::vector<double> J_, R_;      // column by column
  std::vector<double> d_, z_, r_;  // of one step
  std::vector<int> active_;
  std::vector<double> weights_;
  int n_ = 0, count_ = 0, proof_ = 0, steps_ = 0;
};

}  // namespace brunt::depth
