// SPDX-License-Identifier: Apache-2.0
// A sparse matrix with its factors by MUMPS, on the ranks of an MPI communicator that each own a contiguous range of
// rows. On one rank the bits of every result depend only on the matrix and the right-hand side.
#pragma once
#include <mpi.h>

#include <memory>
#include <span>
#include <vector>

#include "comm/linear_system.hpp"
#include "mumps.hpp"
#include "row_range.hpp"

namespace brunt::comm {

class SparseFactors {
 public:
  explicit SparseFactors(MPI_Comm comm) : comm_(comm) {}

  /// `same_pattern`: the columns are unchanged since the last call, on all ranks.
  Factorised factorise(RowRange&& rows, bool same_pattern);
  /// Refined x and its componentwise backward error; NaN if x is not finite.
  double solve(std::span<const double> b, std::span<double> x);
  std::vector<double> null_vector(GlobalIndex which);

 private:
  Factorised factorise_with_room(double null_pivot);
  Factorised factorise_with(int more_room, double null_pivot);
  bool is_singular();
  /// Scaling factors of the rows and columns of this rank, with which all largest entries are near 1: equations of
  /// contact and pressures have different units, so the factors of a row and of the column with the same number differ.
  struct Equilibration {
    std::vector<double> row, column;
  };
  Equilibration equilibration();
  std::span<const double> of_all_ranks(std::span<const double> own);
  double residual(std::span<const double> b, std::span<const double> x, std::span<double> r);

  MPI_Comm comm_;
  RowRange rows_;
  RankShares shares_;  // of rows
  std::unique_ptr<Mumps> factors_;
  std::vector<double> of_all_;    // values of a vector on all ranks
  std::vector<double> floating_;  // a null direction, from inverse iteration
};

}  // namespace brunt::comm
