// SPDX-License-Identifier: Apache-2.0
#include "mumps.hpp"

#include <algorithm>
#include <new>
#include <string>
#include <type_traits>

#include "core/error.hpp"
#include "core/types.hpp"
#include "fill_order.hpp"

namespace brunt::comm {

static_assert(std::is_same_v<MUMPS_INT, SolverIndex>, "MUMPS is built with indices of 32 bits");

RankShares shares_of_ranks(MPI_Comm comm, SolverIndex own) {
  int ranks = 1;
  MPI_Comm_size(comm, &ranks);
  RankShares shares{std::vector<int>(static_cast<std::size_t>(ranks)), std::vector<int>(1, 0)};
  MPI_Allgather(&own, 1, MPI_INT, shares.count.data(), 1, MPI_INT, comm);
  for (const int count : shares.count) shares.first.push_back(shares.first.back() + count);
  return shares;
}

namespace {

namespace job {
constexpr int begin = -1, end = -2, analysis = 1, factorisation = 2, solution = 3;
}

// Controls of MUMPS by their numbers in its guide (5.5.1, sections 6.1 and 6.2).
namespace control_of {
constexpr int printing = 4, permutation = 6, ordering = 7, scaling = 8, root = 13, more_room = 14, matrix = 18;
constexpr int detect_null = 24, null_vector = 25, analysis = 28;
constexpr int null_threshold = 3;  // a control of real type
}  // namespace control_of

constexpr int both_sides_work = 1;  // the first rank takes part in the factorisation
constexpr int unsymmetric = 0, general_symmetric = 2;
// Negative pivots are counted wherever the last front is not split by ScaLAPACK.
constexpr int root_in_sequence = 1;
// The analysis uses only the pattern: no permutation by values. So factors do not depend on whether the analysis was
// repeated.
constexpr int no_permutation = 0;
// Rows and columns are scaled in the factorisation, when values are known, not in the analysis.
constexpr int scale_by_values = 7;
// Operations for 20^3 hexahedra by elimination order: METIS 27 Gflop, PORD 35 (which aborts on some small graphs),
// approximate minimum fill 68, minimum degree 86. The packaged MUMPS of Debian has no METIS, so the order is passed to
// it.
constexpr int given_order = 1;
constexpr int analysis_on_the_first_rank = 1;
constexpr int whole_on_the_first_rank = 0, each_rank_its_entries = 3;

/// The pattern of all ranks, on the first of them; empty elsewhere.
struct Pattern {
  std::vector<SolverIndex> begin, column;
};
Pattern gathered_pattern(MPI_Comm comm, int rank, const RankShares& rows, const RowRange& range) {
  const RankShares entries = shares_of_ranks(comm, range.begin.back());
  Pattern whole;
  if (rank == 0) {
    whole.begin.resize(static_cast<std::size_t>(range.unknowns) + 1);
    whole.column.resize(static_cast<std::size_t>(entries.first.back()));
  }
  std::vector<SolverIndex> end(range.begin.begin() + 1, range.begin.end());
  for (SolverIndex& place : end) place += nth(entries.first, rank);
  MPI_Gatherv(end.data(), range.rows(), MPI_INT, rank == 0 ? whole.begin.data() + 1 : nullptr, rows.count.data(),
              rows.first.data(), MPI_INT, 0, comm);
  MPI_Gatherv(range.column.data(), range.begin.back(), MPI_INT, whole.column.data(), entries.count.data(),
              entries.first.data(), MPI_INT, 0, comm);
  return whole;
}

}  // namespace

Mumps::Mumps(MPI_Comm comm, Kind kind) : comm_(comm), kind_(kind) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &ranks_);
  solver_.sym = kind == Kind::symmetric ? general_symmetric : unsymmetric;
  solver_.par = both_sides_work;
  solver_.comm_fortran = MPI_Comm_c2f(comm_);
  call(job::begin);
  control(control_of::printing) = 0;
}

Mumps::~Mumps() {
  int ended = 0;
  MPI_Finalized(&ended);
  if (ended == 0) call(job::end);
}

void Mumps::call(int job) {
  solver_.job = job;
  dmumps_c(&solver_);
}

void Mumps::order(const RowRange& rows) {
  enum : int { done, failed, memory_lacks };
  int outcome = done;
  std::string failure = "METIS failed to order a matrix";
  const Pattern whole = ranks_ > 1 ? gathered_pattern(comm_, rank_, rows_, rows) : Pattern{};
  if (rank_ == 0) {
    try {
      position_ =
          ranks_ > 1 ? elimination_order(whole.begin, whole.column) : elimination_order(rows.begin, rows.column);
      for (SolverIndex& place : position_) ++place;
    } catch (const std::bad_alloc&) {
      outcome = memory_lacks;
    } catch (const MachineError& error) {
      outcome = failed;
      failure = error.what();
    }
  }
  MPI_Bcast(&outcome, 1, MPI_INT, 0, comm_);
  if (outcome == memory_lacks) throw std::bad_alloc();
  if (outcome == failed) throw MachineError(failure);
}

void Mumps::analyse(const RowRange& rows, int more_room) {
  rows_ = shares_of_ranks(comm_, rows.rows());
  order(rows);
  row_.clear();
  column_.clear();
  const SolverIndex first = nth(rows_.first, rank_) + 1;
  for (SolverIndex i = 0; i < rows.rows(); ++i)
    for (auto k = nth(rows.begin, i); k < rows.begin[static_cast<std::size_t>(i) + 1]; ++k) {
      row_.push_back(first + i);
      column_.push_back(nth(rows.column, k) + 1);
    }
  solver_.n = rows.unknowns;
  if (ranks_ == 1) {
    solver_.nnz = static_cast<MUMPS_INT8>(row_.size());
    solver_.irn = row_.data();
    solver_.jcn = column_.data();
  } else {
    solver_.nnz_loc = static_cast<MUMPS_INT8>(row_.size());
    solver_.irn_loc = row_.data();
    solver_.jcn_loc = column_.data();
  }
  solver_.perm_in = position_.data();
  control(control_of::matrix) = ranks_ == 1 ? whole_on_the_first_rank : each_rank_its_entries;
  control(control_of::permutation) = no_permutation;
  control(control_of::ordering) = given_order;
  control(control_of::analysis) = analysis_on_the_first_rank;
  control(control_of::scaling) = scale_by_values;
  control(control_of::more_room) = more_room;
  control(control_of::detect_null) = kind_ == Kind::symmetric ? 0 : 1;
  if (kind_ == Kind::symmetric) control(control_of::root) = root_in_sequence;
  call(job::analysis);
}

void Mumps::factorise(const RowRange& rows, double null_pivot) {
  value_ = rows.value;
  (ranks_ == 1 ? solver_.a : solver_.a_loc) = value_.data();
  solver_.cntl[control_of::null_threshold - 1] = null_pivot;
  call(job::factorisation);
}

/// For the right-hand side in `all_`, which is replaced by the solution.
void Mumps::substitute(std::span<double> x) {
  solver_.rhs = all_.data();
  call(job::solution);
  if (status() < 0)
    throw MachineError("MUMPS: error " + std::to_string(status()) + " (" + std::to_string(detail()) + ") in a solve");
  MPI_Scatterv(all_.data(), rows_.count.data(), rows_.first.data(), MPI_DOUBLE, x.data(), static_cast<int>(x.size()),
               MPI_DOUBLE, 0, comm_);
}

void Mumps::solve(std::span<const double> b, std::span<double> x) {
  all_.resize(rank_ == 0 ? static_cast<std::size_t>(solver_.n) : 0);
  MPI_Gatherv(b.data(), static_cast<int>(b.size()), MPI_DOUBLE, all_.data(), rows_.count.data(), rows_.first.data(),
              MPI_DOUBLE, 0, comm_);
  substitute(x);
}

void Mumps::null_vector(int which, std::span<double> x) {
  all_.assign(rank_ == 0 ? static_cast<std::size_t>(solver_.n) : 0, 0.0);
  control(control_of::null_vector) = which + 1;
  substitute(x);
  control(control_of::null_vector) = 0;
}

}  // namespace brunt::comm
