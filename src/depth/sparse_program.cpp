// SPDX-License-Identifier: Apache-2.0
#include "depth/sparse_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brunt::depth {
namespace {

constexpr double dependent = 1e-13;   // as in quadratic_program.cpp
constexpr int most_steps = 400;       // of one call, at least
constexpr int steps_an_unknown = 20;  // of one call; random stacks of ten boxes need about 2

constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

double SparseRow::norm() const {
  double sum = 0;
  for (std::size_t i = 0; i < at(count); ++i) sum += value[i] * value[i];
  return std::sqrt(sum);
}

SparseProgram::SparseProgram(std::span<const double> G, std::span<const double> g)
    : G_(G.begin(), G.end()),
      g_(g.begin(), g.end()),
      x_(g.size(), 0.0),
      J_(G.size(), 0.0),
      R_(G.size(), 0.0),
      d_(g.size()),
      z_(g.size()),
      r_(g.size()),
      active_(g.size() + 1),
      weights_(g.size() + 1),
      n_(static_cast<int>(g.size())) {
  const std::size_t n = g.size();
  std::vector<double> L(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = G_[i * n + j];
      for (std::size_t k = 0; k < j; ++k) rest -= L[i * n + k] * L[j * n + k];
      L[i * n + j] = i == j ? std::sqrt(rest) : rest / L[j * n + j];
    }
  for (std::size_t i = 0; i < n; ++i)  // column i of L^-1 is row i of J
    for (std::size_t j = i; j < n; ++j) {
      double rest = i == j ? 1 : 0;
      for (std::size_t k = i; k < j; ++k) rest -= L[j * n + k] * J_[k * n + i];
      J_[j * n + i] = rest / L[j * n + j];
    }
  for (int k = 0; k < n_; ++k) {
    const double* J = column(k);
    double along = 0;
    for (std::size_t i = 0; i < n; ++i) along += J[i] * g_[i];
    for (std::size_t i = 0; i < n; ++i) x_[i] -= along * J[i];
  }
}

double SparseProgram::value() const {
  const std::size_t n = x_.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < n; ++j) row += G_[i * n + j] * x_[j];
    sum += x_[i] * (0.5 * row + g_[i]);
  }
  return sum;
}

int SparseProgram::most_violated(std::span<const SparseRow> rows, double tolerance) const {
  int worst = -1;
  double least = -tolerance;
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const SparseRow& row = rows[at(i)];
    const double slack = row.times(x_.data()) - row.bound;
    if (slack >= 0) continue;
    const double length = row.norm(), relative = length > 0 ? slack / length : slack;
    if (relative >= least || std::find(active_.begin(), active_.begin() + count_, i) != active_.begin() + count_)
      continue;
    least = relative;
    worst = i;
  }
  return worst;
}

/// Columns k and k + 1 of J.
void SparseProgram::rotate(int k, double c, double s) {
  double *left = column(k), *right = column(k + 1);
  for (int i = 0; i < n_; ++i) {
    const double a = left[i], b = right[i];
    left[i] = c * a + s * b;
    right[i] = c * b - s * a;
  }
}

/// Activates the row with J^T n = d_.
void SparseProgram::add() {
  for (int k = n_ - 1; k > count_; --k) {
    const double length = std::hypot(d_[at(k - 1)], d_[at(k)]);
    if (!(length > 0)) continue;
    const double c = d_[at(k - 1)] / length, s = d_[at(k)] / length;
    d_[at(k - 1)] = length;
    rotate(k - 1, c, s);
  }
  for (int i = 0; i <= count_; ++i) R(i, count_) = d_[at(i)];
  ++count_;
}

void SparseProgram::drop(int place) {
  for (int k = place; k + 1 < count_; ++k) {
    for (int i = 0; i <= k + 1; ++i) R(i, k) = R(i, k + 1);
    active_[at(k)] = active_[at(k + 1)];
    weights_[at(k)] = weights_[at(k + 1)];
  }
  --count_;
  for (int k = place; k < count_; ++k) {  // column k now reaches one below the diagonal
    const double length = std::hypot(R(k, k), R(k + 1, k));
    if (!(length > 0)) continue;
    const double c = R(k, k) / length, s = R(k + 1, k) / length;
    for (int i = k; i < count_; ++i) {
      const double upper = R(k, i), lower = R(k + 1, i);
      R(k, i) = c * upper + s * lower;
      R(k + 1, i) = c * lower - s * upper;
    }
    rotate(k, c, s);
  }
}

Outcome SparseProgram::enter(std::span<const SparseRow> rows, int entering) {
  const SparseRow& row = rows[at(entering)];
  double weight = 0;
  for (;; ++steps_) {
    double outside = 0, all = 0;  // squares of the part of the normal outside the span of the active ones, and of all
    std::fill(z_.begin(), z_.end(), 0.0);
    for (int k = 0; k < n_; ++k) {
      const double* J = column(k);
      const double d = row.times(J);
      d_[at(k)] = d;
      all += d * d;
      if (k < count_) continue;
      outside += d * d;
      for (int i = 0; i < n_; ++i) z_[at(i)] += d * J[i];
    }
    for (int k = count_ - 1; k >= 0; --k) {
      double rest = d_[at(k)];
      for (int c = k + 1; c < count_; ++c) rest -= R(k, c) * r_[at(c)];
      r_[at(k)] = rest / R(k, k);
    }
    double dual_step = std::numeric_limits<double>::infinity();
    int leaving = -1;
    for (int k = 0; k < count_; ++k)
      if (r_[at(k)] > 0 && weights_[at(k)] < dual_step * r_[at(k)]) {
        dual_step = weights_[at(k)] / r_[at(k)];
        leaving = k;
      }
    const bool free = count_ < n_ && outside > dependent * dependent * all;
    if (!free && leaving < 0) {  // r <= 0: n = sum r_k n_k
      for (int k = 0; k < count_; ++k) weights_[at(k)] = std::max(0.0, -r_[at(k)]);
      active_[at(count_)] = entering;
      weights_[at(count_)] = 1;
      proof_ = 1;
      return Outcome::infeasible;
    }
    const double full_step = free ? (row.bound - row.times(x_.data())) / outside : dual_step;
    const double step = std::min(dual_step, full_step);
    if (free)
      for (int i = 0; i < n_; ++i) x_[at(i)] += step * z_[at(i)];
    for (int k = 0; k < count_; ++k) weights_[at(k)] = std::max(0.0, weights_[at(k)] - step * r_[at(k)]);
    weight += step;
    if (free && full_step <= dual_step) {
      active_[at(count_)] = entering;
      weights_[at(count_)] = weight;
      add();
      return Outcome::solved;
    }
    drop(leaving);
  }
}

Outcome SparseProgram::solve(std::span<const SparseRow> rows, double tolerance) {
  proof_ = 0;
  const int limit = steps_ + std::max(most_steps, steps_an_unknown * n_);
  for (; steps_ < limit; ++steps_) {
    const int entering = most_violated(rows, tolerance);
    if (entering < 0) return Outcome::solved;
    if (enter(rows, entering) == Outcome::infeasible) return Outcome::infeasible;
  }
  return Outcome::stalled;
}

}  // namespace brunt::depth
