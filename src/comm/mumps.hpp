// SPDX-License-Identifier: Apache-2.0
// LU or L D L^T factors of one sparse matrix by MUMPS on the ranks of an MPI communicator. MUMPS is called directly,
// since PETSc does not pass a user-defined elimination order to it on several ranks. Every member is collective, and
// every error is a status known to all ranks.
#pragma once
#include <dmumps_c.h>
#include <mpi.h>

#include <array>
#include <span>
#include <vector>

#include "row_range.hpp"

namespace brunt::comm {

/// Number of items on each rank, and on all ranks below it: counts and displacements of MPI calls on arrays of variable
/// length.
struct RankShares {
  std::vector<int> count, first;
};

/// Collective: `own` items of this rank.
RankShares shares_of_ranks(MPI_Comm comm, SolverIndex own);

class Mumps {
 public:
  /// Status of MUMPS (its guide, 5.5.1, section 8): 0 done, below 0 an error.
  static constexpr int index_space_too_small = -8, work_space_too_small = -9, no_memory = -13;

  /// Work space beyond the estimate [%], required by delayed pivots (zeros on the diagonal). Tried one after the other.
  static constexpr std::array<int, 4> rooms{50, 200, 800, 3200};

  enum class Kind {
    unsymmetric,
    symmetric,  ///< of the entries (i, j) and (j, i) the sum counts for both; null pivots are not looked for
  };

  explicit Mumps(MPI_Comm comm, Kind kind = Kind::unsymmetric);
  ~Mumps();
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// Computes the elimination order from the pattern only, by METIS on the first rank. more_room: work space beyond the
  /// estimate [%]. Throws MachineError or bad_alloc, on all ranks, if the ordering fails.
  void analyse(const RowRange& rows, int more_room);
  /// For rows with the analysed pattern. Pivots below null_pivot of the scaled matrix are null.
  void factorise(const RowRange& rows, double null_pivot);
  /// Values of the rows of this rank. Throws MachineError, on all ranks, if MUMPS fails.
  void solve(std::span<const double> b, std::span<double> x);
  /// The null vector number `which`, from 0: there are as many as null pivots.
  void null_vector(int which, std::span<double> x);

  [[nodiscard]] int status() const { return info(1); }
  [[nodiscard]] int detail() const { return info(2); }
  [[nodiscard]] bool lacks_room() const {
    return status() == work_space_too_small || status() == index_space_too_small;
  }
  [[nodiscard]] int null_pivots() const { return info(28); }
  [[nodiscard]] int negative_pivots() const { return info(12); }             ///< of a symmetric matrix
  [[nodiscard]] double memory() const { return 1e6 * info(19); }             ///< [bytes] of all ranks together
  [[nodiscard]] double operations() const { return solver_.rinfog[3 - 1]; }  ///< of the elimination, on all ranks

 private:
  void call(int job);
  void order(const RowRange& rows);
  void substitute(std::span<double> x);
  [[nodiscard]] int info(int which) const { return solver_.infog[which - 1]; }
  [[nodiscard]] MUMPS_INT& control(int which) { return solver_.icntl[which - 1]; }

  MPI_Comm comm_;
  Kind kind_;
  int rank_ = 0, ranks_ = 1;
  DMUMPS_STRUC_C solver_{};
  std::vector<SolverIndex> row_, column_, position_;  // of entries, from 1; in the order of elimination, from 1
  std::vector<double> value_, all_;                   // of all unknowns, on the first rank
  RankShares rows_;
};

}  // namespace brunt::comm
