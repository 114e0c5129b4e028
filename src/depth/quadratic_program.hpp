// SPDX-License-Identifier: Apache-2.0
// Strictly convex quadratic programs in a few unknowns,
//   minimise 1/2 x^T G x + g^T x   subject to   n_i . x >= b_i,
// by the dual active-set method of D. Goldfarb, A. Idnani, Math. Programming 27 (1983) 1-33. It starts at the
// unconstrained minimum and adds the most violated row to the active set, step by step; each intermediate point is the
// minimum under the active rows. Rows may therefore be appended after a solution, and the next call continues from it.
// The factor J = L^-T Q (G = L L^T) and the triangle R of the active normals, J^T N = (R; 0), are updated by Givens
// rotations. Nothing is allocated.
#pragma once
#include <Eigen/Core>
#include <array>
#include <limits>
#include <span>

namespace brunt::depth {

template <int N>
struct Row {
  Eigen::Matrix<double, N, 1> normal = Eigen::Matrix<double, N, 1>::Zero();
  double bound = 0;
};

enum class Outcome {
  solved,
  infeasible,  ///< weights() contains a proof
  stalled,     ///< too many steps: rounding in a degenerate problem; x() is not feasible
};

/// Instances for N = 3, 5, 6, 7. Units are those of the caller: unknowns should be scaled to one unit of length.
template <int N>
class QuadraticProgram {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  /// G symmetric and positive definite. The active set is emptied.
  QuadraticProgram(const Matrix& G, const Vector& g);

  /// Rows of earlier calls must come first and unchanged. A row counts as satisfied if n . x >= b - tolerance |n|.
  /// Rows with a zero normal are satisfied or make the program infeasible.
  Outcome solve(std::span<const Row<N>> rows, double tolerance);

  [[nodiscard]] const Vector& x() const { return x_; }
  /// 1/2 x^T G x + g^T x
  [[nodiscard]] double value() const { return 0.5 * x_.dot(G_ * x_) + g_.dot(x_); }
  /// Indices of the active rows, at most N; if infeasible, followed by the last row of the proof.
  [[nodiscard]] std::span<const int> active() const {
    return {active_.data(), static_cast<std::size_t>(count_ + proof_)};
  }
  /// Solved: the multipliers, G x + g = sum w_i n_i. Infeasible: w_i >= 0 with sum w_i n_i = 0 and sum w_i b_i > 0
  /// (Farkas), the last w is 1.
  [[nodiscard]] std::span<const double> weights() const {
    return {weights_.data(), static_cast<std::size_t>(count_ + proof_)};
  }
  [[nodiscard]] int steps() const { return steps_; }  ///< since construction

 private:
  using Small = std::array<double, static_cast<std::size_t>(N) + 1>;
  [[nodiscard]] int most_violated(std::span<const Row<N>> rows, double tolerance) const;
  Outcome enter(std::span<const Row<N>> rows, int entering);
  void add(Vector d);
  void drop(int place);

  Matrix G_, J_, R_ = Matrix::Zero();
  Vector g_, x_;
  std::array<int, static_cast<std::size_t>(N) + 1> active_{};
  Small weights_{};
  int count_ = 0, proof_ = 0, steps_ = 0;
};

extern template class QuadraticProgram<3>;
extern template class QuadraticProgram<5>;
extern template class QuadraticProgram<6>;
extern template class QuadraticProgram<7>;

}  // namespace brunt::depth
