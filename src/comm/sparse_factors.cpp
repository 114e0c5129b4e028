// SPDX-License-Identifier: Apache-2.0
#include "sparse_factors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>

#include "core/error.hpp"

namespace brunt::comm {
namespace {

// Pivots below this share of the largest entry of the scaled matrix (which is 1) are certainly zero: rows of zeros,
// linearly dependent rows. Constrained bodies have larger ones (a strip 10^4 times as long as thick: 1e-11).
constexpr double surely_null = 1e-13;
// The same threshold for unconstrained rigid bodies, used only if the matrix was found singular. Their pivots are
// rounding errors amplified by the elimination: 1e-12 (a cube of 10 elements an edge) to 1e-8 (a plate 300 times as
// wide as thick).
constexpr double null_if_singular = 1e-8;
// Smallest eigenvalues of the equilibrated matrix below this, by inverse iteration, are zero. They are 3e-18 to 1e-16
// for unconstrained bodies, 3e-11 for a bar 400 times as long as thick, 4e-13 for a strip 10^4 times as long as thick.
constexpr double smallest_value = 1e-14;
constexpr int inverse_iterations = 3, scaling_sweeps = 5;

constexpr int most_refinements = 2;
constexpr double accurate = 2 * std::numeric_limits<double>::epsilon();

/// Maximum that propagates NaN.
void keep_largest(double& largest, double value) {
  if (!(value <= largest) && !std::isnan(largest)) largest = value;
}

double largest_of_ranks(MPI_Comm comm, double value) {
  // checked separately: the reduction may lose a NaN
  std::array<double, 2> pair{std::isnan(value) ? 0 : value, std::isnan(value) ? 1.0 : 0.0};
  MPI_Allreduce(MPI_IN_PLACE, pair.data(), 2, MPI_DOUBLE, MPI_MAX, comm);
  return pair[1] > 0 ? std::numeric_limits<double>::quiet_NaN() : pair[0];
}

}  // namespace

Factorised SparseFactors::factorise_with(int more_room, double null_pivot) {
  Factorised done;
  if (factors_ == nullptr) {
    factors_ = std::make_unique<Mumps>(comm_);
    factors_->analyse(rows_, more_room);
    done.analysed = true;
  }
  if (factors_->status() >= 0) factors_->factorise(rows_, null_pivot);
  const int status = factors_->status();
  done.memory = factors_->memory();
  done.operations = factors_->operations();
  done.null_pivots = factors_->null_pivots();
  if (status >= 0) {
    done.status = done.null_pivots > 0 ? FactorStatus::singular : FactorStatus::done;
    return done;
  }
  const bool memory =
      status == Mumps::no_memory || status == Mumps::work_space_too_small || status == Mumps::index_space_too_small;
  done.status = memory ? FactorStatus::out_of_memory : FactorStatus::failed;
  done.message = "MUMPS: error " + std::to_string(status) + " (" + std::to_string(factors_->detail()) + ")";
  return done;
}

Factorised SparseFactors::factorise_with_room(double null_pivot) {
  Factorised done;
  bool analysed = false;
  for (const int more_room : Mumps::rooms) {
    done = factorise_with(more_room, null_pivot);
    analysed = analysed || done.analysed;
    const bool again = done.status == FactorStatus::out_of_memory && factors_->status() != Mumps::no_memory;
    if (done.status == FactorStatus::out_of_memory || done.status == FactorStatus::failed) factors_.reset();
    if (!again) break;
  }
  done.analysed = analysed;
  return done;
}

Factorised SparseFactors::factorise(RowRange&& rows, bool same_pattern) {
  Factorised done;
  try {
    rows_ = std::move(rows);
    shares_ = shares_of_ranks(comm_, rows_.rows());
    floating_.clear();
    if (!same_pattern) factors_.reset();
    done = factorise_with_room(surely_null);
    if (done.status == FactorStatus::singular || (done.ok() && is_singular())) {
      const bool analysed = done.analysed;
      done = factorise_with_room(null_if_singular);
      done.analysed = analysed || done.analysed;
      if (done.ok()) {  // no null pivot was found, but one direction is known
        done.status = FactorStatus::singular;
        done.null_pivots = 1;
      }
    }
  } catch (const MachineError& failure) {
    factors_.reset();
    done.status = FactorStatus::failed;
    done.message = failure.what();
  } catch (const std::bad_alloc&) {
    factors_.reset();
    done.status = FactorStatus::out_of_memory;
    done.message = "no memory for the rows of the matrix";
  }
  return done;
}

SparseFactors::Equilibration SparseFactors::equilibration() {
  const std::size_t rows = static_cast<std::size_t>(rows_.rows()), columns = static_cast<std::size_t>(rows_.unknowns);
  Equilibration of{std::vector<double>(rows, 1.0), std::vector<double>(columns, 1.0)};
  std::vector<double> in_column(columns);
  for (int sweep = 0; sweep < scaling_sweeps; ++sweep) {
    std::vector<double> row = of.row;
    std::ranges::fill(in_column, 0.0);
    for (std::size_t i = 0; i < rows; ++i) {
      double largest = 0;
      for (auto k = static_cast<std::size_t>(rows_.begin[i]); k < static_cast<std::size_t>(rows_.begin[i + 1]); ++k) {
        const auto j = static_cast<std::size_t>(rows_.column[k]);
        const double value = std::abs(rows_.value[k]) * of.row[i] * of.column[j];
        largest = std::max(largest, value);
        in_column[j] = std::max(in_column[j], value);
      }
      if (largest > 0) row[i] /= std::sqrt(largest);
    }
    MPI_Allreduce(MPI_IN_PLACE, in_column.data(), static_cast<int>(columns), MPI_DOUBLE, MPI_MAX, comm_);
    of.row = row;
    for (std::size_t j = 0; j < columns; ++j)
      if (in_column[j] > 0) of.column[j] /= std::sqrt(in_column[j]);
  }
  int rank = 0;
  MPI_Comm_rank(comm_, &rank);
  const int first = nth(shares_.first, rank);
  of.column = {of.column.begin() + first, of.column.begin() + first + static_cast<std::ptrdiff_t>(rows)};
  return of;
}

/// Inverse iteration on the equilibrated matrix; a null direction is stored in `floating_`.
bool SparseFactors::is_singular() {
  const Equilibration scale = equilibration();
  std::vector<double> z(scale.row.size()), b(z.size()), y(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = std::sin(static_cast<double>(i + 1));
  double size = 1;
  for (int step = 0; step < inverse_iterations; ++step) {
    for (std::size_t i = 0; i < z.size(); ++i) b[i] = z[i] / scale.row[i];
    factors_->solve(b, y);
    size = 0;
    for (std::size_t i = 0; i < z.size(); ++i) keep_largest(size, std::abs(z[i] = y[i] / scale.column[i]));
    size = largest_of_ranks(comm_, size);
    for (double& value : z) value /= size;
  }
  if (1 / size > smallest_value) return false;
  floating_ = std::isfinite(size) ? y : std::vector<double>{};
  return true;
}

std::span<const double> SparseFactors::of_all_ranks(std::span<const double> own) {
  if (shares_.count.size() == 1) return own;
  of_all_.resize(static_cast<std::size_t>(rows_.unknowns));
  MPI_Allgatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, of_all_.data(), shares_.count.data(),
                 shares_.first.data(), MPI_DOUBLE, comm_);
  return of_all_;
}

/// r = b - A x; the largest |r|_i / (|A| |x| + |b|)_i.
double SparseFactors::residual(std::span<const double> b, std::span<const double> x, std::span<double> r) {
  const std::span<const double> every = of_all_ranks(x);
  double worst = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    double sum = b[i], size = std::abs(b[i]);
    for (auto k = static_cast<std::size_t>(rows_.begin[i]); k < static_cast<std::size_t>(rows_.begin[i + 1]); ++k) {
      const double term = rows_.value[k] * nth(every, rows_.column[k]);
      sum -= term;
      size += std::abs(term);
    }
    r[i] = sum;
    const double share = size == 0 ? 0.0 : std::abs(sum) / size;
    keep_largest(worst, share);
  }
  return largest_of_ranks(comm_, worst);
}

double SparseFactors::solve(std::span<const double> b, std::span<double> x) {
  factors_->solve(b, x);
  std::vector<double> r(x.size()), better(x.size()), correction(x.size());
  double error = residual(b, x, r);
  for (int step = 0; step < most_refinements && error > accurate; ++step) {
    factors_->solve(r, correction);
    for (std::size_t i = 0; i < x.size(); ++i) better[i] = x[i] + correction[i];
    const double now = residual(b, better, r);
    if (!(now < error)) break;
    error = now;
    std::ranges::copy(better, x.begin());
  }
  return error;
}

std::vector<double> SparseFactors::null_vector(GlobalIndex which) {
  std::vector<double> direction = floating_;
  if (factors_->null_pivots() > 0) {
    direction.resize(static_cast<std::size_t>(rows_.rows()));
    factors_->null_vector(static_cast<int>(which), direction);
  }
  double largest = 0;
  for (const double value : direction) keep_largest(largest, std::abs(value));
  largest = largest_of_ranks(comm_, largest);
  if (!(largest > 0 && std::isfinite(largest))) return {};
  for (double& value : direction) value /= largest;
  return direction;
}

}  // namespace brunt::comm
