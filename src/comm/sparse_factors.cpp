// SPDX-License-Identifier: Apache-2.0
#include "sparse_factors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>

#include "brunt/core/error.hpp"
#include "fill_order.hpp"
#include "petsc_errors.hpp"

namespace brunt::comm {
namespace {

// Controls of MUMPS by their numbers in its guide (5.5.1, sections 6.1 and 6.2).
namespace control {
constexpr PetscInt printing = 4, permutation = 6, scaling = 8, relaxation = 14, detect_null = 24, null_vector = 25;
constexpr PetscInt null_threshold = 3;  // a real one
}  // namespace control
namespace result {
constexpr PetscInt status = 1, detail = 2, megabytes = 19, null_pivots = 28;
}

// The analysis sees the pattern alone: no permutation by values. So factors do not depend on whether it was done anew.
constexpr PetscInt no_permutation = 0;
// Rows and columns are scaled when values are known, not at the analysis.
constexpr PetscInt scale_by_values = 7;
constexpr const char* prefix = "brunt_linear_";
// Operations of 20^3 hexahedra by order of elimination: METIS 27 Gflop, PORD 35 (which ends the program on some small
// graphs), approximate minimum fill 68, minimum degree 86. Debian's MUMPS has no METIS of its own: on one rank it is
// given the order, on several it takes approximate minimum fill.
constexpr const char* ordering = "-brunt_linear_mat_mumps_icntl_7";
constexpr const char *given = "7", *minimum_fill = "2";  // PETSc hands over an order where the choice is left open
// Null vectors are not to be had with a distributed right-hand side (PETSc's default).
constexpr const char* right_hand_side = "-brunt_linear_mat_mumps_icntl_20";
constexpr const char* on_the_root = "0";

// Pivots below this share of the largest entry of the scaled matrix (which is 1) are zero beyond doubt: rows of zeros,
// rows that repeat others. Held bodies have larger ones (a strip 10^4 times as long as thick: 1e-11).
constexpr double surely_null = 1e-13;
// A body that floats leaves larger ones, too: 1e-12 (a cube of 10 elements an edge) to 1e-8 (a plate 300 times as wide
// as thick), rounding times what elimination makes of it. They are asked for only where the matrix was found singular.
constexpr double null_if_singular = 1e-8;
// Inverse iteration finds it: the smallest value of the equilibrated matrix was seen at 3e-18 to 1e-16 where bodies
// float, at 3e-11 for a bar 400 times as long as thick, at 4e-13 for a strip 10^4 times as long as thick.
constexpr double smallest_value = 1e-14;
constexpr int inverse_iterations = 3, scaling_sweeps = 5;

// Work space beyond the estimate [%]: pivots that are put off (zeros on the diagonal) need it. Tried one by one.
constexpr std::array<PetscInt, 4> relaxations{50, 200, 800, 3200};
constexpr PetscInt work_space_too_small = -9, index_space_too_small = -8, no_memory = -13;

constexpr int most_refinements = 2;
constexpr double accurate = 2 * std::numeric_limits<double>::epsilon();

/// A NaN wins, and stays.
void keep_largest(double& largest, double value) {
  if (!(value <= largest) && !std::isnan(largest)) largest = value;
}

double largest_of_ranks(MPI_Comm comm, double value) {
  // a NaN must win: the reduction may lose it
  std::array<double, 2> pair{std::isnan(value) ? 0 : value, std::isnan(value) ? 1.0 : 0.0};
  MPI_Allreduce(MPI_IN_PLACE, pair.data(), 2, MPI_DOUBLE, MPI_MAX, comm);
  return pair[1] > 0 ? std::numeric_limits<double>::quiet_NaN() : pair[0];
}

}  // namespace

SparseFactors::~SparseFactors() {
  PetscBool ended = PETSC_FALSE;
  PetscFinalized(&ended);
  if (ended == PETSC_TRUE) return;
  free_factors();
  MatDestroy(&matrix_);
  VecDestroy(&right_);
  VecDestroy(&solution_);
}

void SparseFactors::free_factors() {
  MatDestroy(&factors_);
}

void SparseFactors::make_matrix() {
  const PetscErrors petsc;
  MatDestroy(&matrix_);
  VecDestroy(&right_);
  VecDestroy(&solution_);
  int ranks = 1;
  MPI_Comm_size(comm_, &ranks);
  if (ranks == 1)  // takes the arrays as they are
    petsc.check(MatCreateSeqAIJWithArrays(comm_, rows_.rows(), rows_.unknowns, rows_.begin.data(), rows_.column.data(),
                                          rows_.value.data(), &matrix_));
  else
    petsc.check(MatCreateMPIAIJWithArrays(comm_, rows_.rows(), rows_.rows(), rows_.unknowns, rows_.unknowns,
                                          rows_.begin.data(), rows_.column.data(), rows_.value.data(), &matrix_));
  petsc.check(MatCreateVecs(matrix_, &solution_, &right_));
}

void SparseFactors::analyse(PetscInt relaxation) {
  const PetscErrors petsc;
  free_factors();
  int ranks = 1;
  MPI_Comm_size(comm_, &ranks);
  const bool alone = ranks == 1;
  // PETSc takes these two from its options alone
  petsc.check(PetscOptionsSetValue(nullptr, ordering, alone ? given : minimum_fill));
  petsc.check(PetscOptionsSetValue(nullptr, right_hand_side, on_the_root));
  petsc.check(MatSetOptionsPrefixFactor(matrix_, prefix));
  petsc.check(MatGetFactor(matrix_, MATSOLVERMUMPS, MAT_FACTOR_LU, &factors_));
  petsc.check(MatMumpsSetIcntl(factors_, control::printing, 0));
  petsc.check(MatMumpsSetIcntl(factors_, control::permutation, no_permutation));
  petsc.check(MatMumpsSetIcntl(factors_, control::scaling, scale_by_values));
  petsc.check(MatMumpsSetIcntl(factors_, control::relaxation, relaxation));
  petsc.check(MatMumpsSetIcntl(factors_, control::detect_null, 1));
  MatFactorInfo fill;
  petsc.check(MatFactorInfoInitialize(&fill));
  IS order = nullptr;
  if (alone) {
    const std::vector<PetscInt> position = elimination_order(rows_.begin, rows_.column);
    petsc.check(ISCreateGeneral(comm_, rows_.rows(), position.data(), PETSC_COPY_VALUES, &order));
  }
  const PetscErrorCode code = MatLUFactorSymbolic(factors_, matrix_, order, order, &fill);
  ISDestroy(&order);
  petsc.check(code);
}

PetscInt SparseFactors::info(PetscInt which) const {
  PetscInt value = 0;
  MatMumpsGetInfog(factors_, which, &value);
  return value;
}

Factorised SparseFactors::factorise_with(PetscInt relaxation, double null_pivot) {
  const PetscErrors petsc;
  Factorised done;
  if (factors_ == nullptr) {
    analyse(relaxation);
    done.analysed = true;
  }
  if (info(result::status) >= 0) {
    MatFactorInfo fill;
    petsc.check(MatFactorInfoInitialize(&fill));
    petsc.check(MatMumpsSetCntl(factors_, control::null_threshold, null_pivot));
    petsc.check(MatLUFactorNumeric(factors_, matrix_, &fill));
  }
  const PetscInt status = info(result::status);
  done.memory = 1e6 * info(result::megabytes);
  done.null_pivots = info(result::null_pivots);
  if (status >= 0) {
    done.status = done.null_pivots > 0 ? FactorStatus::singular : FactorStatus::done;
    return done;
  }
  const bool memory = status == no_memory || status == work_space_too_small || status == index_space_too_small;
  done.status = memory ? FactorStatus::out_of_memory : FactorStatus::failed;
  done.message = "MUMPS: error " + std::to_string(status) + " (" + std::to_string(info(result::detail)) + ")";
  return done;
}

Factorised SparseFactors::factorise_with_room(double null_pivot) {
  Factorised done;
  bool analysed = false;
  for (const PetscInt relaxation : relaxations) {
    done = factorise_with(relaxation, null_pivot);
    analysed = analysed || done.analysed;
    const bool again = done.status == FactorStatus::out_of_memory && info(result::status) != no_memory;
    if (done.status == FactorStatus::out_of_memory || done.status == FactorStatus::failed) free_factors();
    if (!again) break;
  }
  done.analysed = analysed;
  return done;
}

Factorised SparseFactors::factorise(RowRange&& rows, bool same_pattern) {
  Factorised done;
  try {
    rows_ = std::move(rows);
    floating_.clear();
    make_matrix();
    if (!same_pattern) free_factors();
    done = factorise_with_room(surely_null);
    if (done.status == FactorStatus::singular || (done.ok() && is_singular())) {
      const bool analysed = done.analysed;
      done = factorise_with_room(null_if_singular);
      done.analysed = analysed || done.analysed;
      if (done.ok()) {  // no pivot tells, but one direction is known
        done.status = FactorStatus::singular;
        done.null_pivots = 1;
      }
    }
  } catch (const PetscFailure& failure) {
    free_factors();
    done.status = failure.code == PETSC_ERR_MEM ? FactorStatus::out_of_memory : FactorStatus::failed;
    done.message = failure.what();
  } catch (const std::bad_alloc&) {
    free_factors();
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
  PetscInt first = 0;
  MatGetOwnershipRange(matrix_, &first, nullptr);
  of.column = {of.column.begin() + first, of.column.begin() + first + static_cast<std::ptrdiff_t>(rows)};
  return of;
}

/// Inverse iteration on the equilibrated matrix; the direction that grows is kept in `floating_`.
bool SparseFactors::is_singular() {
  const Equilibration scale = equilibration();
  std::vector<double> z(scale.row.size()), b(z.size()), y(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = std::sin(static_cast<double>(i + 1));
  double size = 1;
  for (int step = 0; step < inverse_iterations; ++step) {
    for (std::size_t i = 0; i < z.size(); ++i) b[i] = z[i] / scale.row[i];
    substitute(b, y);
    size = 0;
    for (std::size_t i = 0; i < z.size(); ++i) keep_largest(size, std::abs(z[i] = y[i] / scale.column[i]));
    size = largest_of_ranks(comm_, size);
    for (double& value : z) value /= size;
  }
  if (1 / size > smallest_value) return false;
  floating_ = std::isfinite(size) ? y : std::vector<double>{};
  return true;
}

void SparseFactors::substitute(std::span<const double> b, std::span<double> x) {
  const PetscErrors petsc;
  double* to = nullptr;
  petsc.check(VecGetArrayWrite(right_, &to));
  std::ranges::copy(b, to);
  petsc.check(VecRestoreArrayWrite(right_, &to));
  petsc.check(MatSolve(factors_, right_, solution_));
  const double* from = nullptr;
  petsc.check(VecGetArrayRead(solution_, &from));
  std::copy_n(from, x.size(), x.begin());
  petsc.check(VecRestoreArrayRead(solution_, &from));
}

std::span<const double> SparseFactors::of_all_ranks(std::span<const double> own) {
  int ranks = 1;
  MPI_Comm_size(comm_, &ranks);
  if (ranks == 1) return own;
  const PetscInt* first = nullptr;
  MatGetOwnershipRanges(matrix_, &first);
  std::vector<int> count(static_cast<std::size_t>(ranks));
  for (std::size_t k = 0; k < count.size(); ++k) count[k] = first[k + 1] - first[k];
  of_all_.resize(static_cast<std::size_t>(rows_.unknowns));
  MPI_Allgatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, of_all_.data(), count.data(), first, MPI_DOUBLE,
                 comm_);
  return of_all_;
}

/// r = b - A x; the largest |r|_i / (|A| |x| + |b|)_i.
double SparseFactors::residual(std::span<const double> b, std::span<const double> x, std::span<double> r) {
  const std::span<const double> every = of_all_ranks(x);
  double worst = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    double sum = b[i], size = std::abs(b[i]);
    for (auto k = static_cast<std::size_t>(rows_.begin[i]); k < static_cast<std::size_t>(rows_.begin[i + 1]); ++k) {
      const double term = rows_.value[k] * every[static_cast<std::size_t>(rows_.column[k])];
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
  substitute(b, x);
  std::vector<double> r(x.size()), better(x.size()), correction(x.size());
  double error = residual(b, x, r);
  for (int step = 0; step < most_refinements && error > accurate; ++step) {
    substitute(r, correction);
    for (std::size_t i = 0; i < x.size(); ++i) better[i] = x[i] + correction[i];
    const double now = residual(b, better, r);
    if (!(now < error)) break;
    error = now;
    std::ranges::copy(better, x.begin());
  }
  return error;
}

std::vector<double> SparseFactors::null_vector(GlobalIndex which) {
  const PetscErrors petsc;
  std::vector<double> direction = floating_;
  if (info(result::null_pivots) > 0) {
    const std::vector<double> nothing(static_cast<std::size_t>(rows_.rows()), 0.0);
    direction.resize(nothing.size());
    petsc.check(MatMumpsSetIcntl(factors_, control::null_vector, static_cast<PetscInt>(which) + 1));
    substitute(nothing, direction);
    petsc.check(MatMumpsSetIcntl(factors_, control::null_vector, 0));
  }
  double largest = 0;
  for (const double value : direction) keep_largest(largest, std::abs(value));
  largest = largest_of_ranks(comm_, largest);
  if (!(largest > 0 && std::isfinite(largest))) return {};
  for (double& value : direction) value /= largest;
  return direction;
}

}  // namespace brunt::comm
