// SPDX-License-Identifier: Apache-2.0
#include "depth/quadratic_program.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double dependent = 1e-13;  // part of a normal outside the span of the active ones, relative: rounding
constexpr int most_steps = 400;      // of one call; random problems of 6 unknowns and 200 rows need at most 40

constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// c, s with (c s; -s c) (a, b)^T = (|(a, b)|, 0)^T
struct Givens {
  double c, s;
  Givens(double a, double b) {
    const double length = std::hypot(a, b);
    c = length > 0 ? a / length : 1;
    s = length > 0 ? b / length : 0;
  }
};

}  // namespace

template <int N>
QuadraticProgram<N>::QuadraticProgram(const Matrix& G, const Vector& g) : G_(G), g_(g) {
  Matrix L = Matrix::Zero();
  J_ = Matrix::Zero();
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j <= i; ++j) {
      double rest = G(i, j);
      for (int k = 0; k < j; ++k) rest -= L(i, k) * L(j, k);
      L(i, j) = i == j ? std::sqrt(rest) : rest / L(j, j);
    }
  }
  for (int i = 0; i < N; ++i)  // column i of L^-1 is row i of J
    for (int j = i; j < N; ++j) {
      double rest = i == j ? 1 : 0;
      for (int k = i; k < j; ++k) rest -= L(j, k) * J_(i, k);
      J_(i, j) = rest / L(j, j);
    }
  x_ = -(J_ * (J_.transpose() * g));
}

template <int N>
int QuadraticProgram<N>::most_violated(std::span<const Row<N>> rows, double tolerance) const {
  int worst = -1;
  double least = -tolerance;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const Row<N>& row = rows[at(i)];
    const double slack = row.normal.dot(x_) - row.bound;
    if (slack >= 0) continue;
    const double length = row.normal.norm(), relative = length > 0 ? slack / length : slack;
    if (relative >= least || std::find(active_.begin(), active_.begin() + count_, i) != active_.begin() + count_)
      continue;
    least = relative;
    worst = i;
  }
  return worst;
}

template <int N>
void QuadraticProgram<N>::add(Vector d) {
  for (int k = N - 1; k > count_; --k) {
    const Givens turn(d[k - 1], d[k]);
    d[k - 1] = turn.c * d[k - 1] + turn.s * d[k];
    const Vector left = J_.col(k - 1), right = J_.col(k);
    J_.col(k - 1) = turn.c * left + turn.s * right;
    J_.col(k) = turn.c * right - turn.s * left;
  }
  R_.col(count_).head(count_ + 1) = d.head(count_ + 1);
  ++count_;
}

template <int N>
void QuadraticProgram<N>::drop(int place) {
  for (int k = place; k + 1 < count_; ++k) {
    R_.col(k) = R_.col(k + 1);
    active_[at(k)] = active_[at(k + 1)];
    weights_[at(k)] = weights_[at(k + 1)];
  }
  --count_;
  // column k now reaches one below the diagonal, k >= place
  for (int k = place; k < count_; ++k) {
    const Givens turn(R_(k, k), R_(k + 1, k));
    for (int c = k; c < count_; ++c) {
      const double upper = R_(k, c), lower = R_(k + 1, c);
      R_(k, c) = turn.c * upper + turn.s * lower;
      R_(k + 1, c) = turn.c * lower - turn.s * upper;
    }
    const Vector left = J_.col(k), right = J_.col(k + 1);
    J_.col(k) = turn.c * left + turn.s * right;
    J_.col(k + 1) = turn.c * right - turn.s * left;
  }
}

template <int N>
Outcome QuadraticProgram<N>::enter(std::span<const Row<N>> rows, int entering) {
  const Row<N>& row = rows[at(entering)];
  double weight = 0;
  for (;; ++steps_) {
    const Vector d = J_.transpose() * row.normal;
    Vector z = Vector::Zero(), r = Vector::Zero();
    double outside = 0;  // square of the part of the normal outside the span of the active ones
    for (int k = count_; k < N; ++k) {
      z += d[k] * J_.col(k);
      outside += d[k] * d[k];
    }
    for (int k = count_ - 1; k >= 0; --k) {
      double rest = d[k];
      for (int c = k + 1; c < count_; ++c) rest -= R_(k, c) * r[c];
      r[k] = rest / R_(k, k);
    }
    double dual_step = std::numeric_limits<double>::infinity();
    int leaving = -1;
    for (int k = 0; k < count_; ++k)
      if (r[k] > 0 && weights_[at(k)] < dual_step * r[k]) {
        dual_step = weights_[at(k)] / r[k];
        leaving = k;
      }
    const bool free = count_ < N && outside > dependent * dependent * d.squaredNorm();
    if (!free && leaving < 0) {  // r <= 0: n = sum r_k n_k
      for (int k = 0; k < count_; ++k) weights_[at(k)] = std::max(0.0, -r[k]);
      active_[at(count_)] = entering;
      weights_[at(count_)] = 1;
      proof_ = 1;
      return Outcome::infeasible;
    }
    const double full_step = free ? (row.bound - row.normal.dot(x_)) / outside : dual_step;
    const double step = std::min(dual_step, full_step);
    if (free) x_ += step * z;
    for (int k = 0; k < count_; ++k) weights_[at(k)] = std::max(0.0, weights_[at(k)] - step * r[k]);
    weight += step;
    if (free && full_step <= dual_step) {
      active_[at(count_)] = entering;
      weights_[at(count_)] = weight;
      add(d);
      return Outcome::solved;
    }
    drop(leaving);
  }
}

template <int N>
Outcome QuadraticProgram<N>::solve(std::span<const Row<N>> rows, double tolerance) {
  proof_ = 0;
  for (const int limit = steps_ + most_steps; steps_ < limit; ++steps_) {
    const int entering = most_violated(rows, tolerance);
    if (entering < 0) return Outcome::solved;
    if (enter(rows, entering) == Outcome::infeasible) return Outcome::infeasible;
  }
  return Outcome::stalled;
}

template class QuadraticProgram<3>;
template class QuadraticProgram<5>;
template class QuadraticProgram<6>;
template class QuadraticProgram<7>;

}  // namespace brunt::depth
