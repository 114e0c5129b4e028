// SPDX-License-Identifier: Apache-2.0
// A sparse matrix with its factors by MUMPS, on the ranks of an MPI communicator that each own a contiguous
// range of rows. On one rank the bits of every result depend on the matrix and the right-hand side alone.
#pragma once
#include <mpi.h>

#include <memory>
#include <span>
#include <vector>

#include "brunt/comm/linear_system.hpp"
#include "mumps.hpp"
#include "row_range.hpp"

namespace brunt::comm {

class SparseFactors {
 public:
  explicit SparseFactors(MPI_Comm comm) : comm_(comm) {}

  /// `same_pattern`: columns are those of the last call, on all ranks.
  Factorised factorise(RowRange&& rows, bool same_pattern);
  /// Refined x and its componentwise backward error; NaN if x is not finite.
  double solve(std::span<const double> b, std::span<double> x);
  std::vector<double> null_vector(GlobalIndex which);

 private:
  Factorised factorise_with_room(double null_pivot);
  Factorised factorise_with(int more_room, double null_pivot);
  bool is_singular();
  /// What multiplies rows and columns of this rank until all of them have a largest entry near 1: equations of contact
  /// and pressures have units of their own, so rows and columns of one number are not alike.
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
  std::vector<double> of_all_;    // a vector's values of all ranks
  std::vector<double> floating_;  // a direction without stiffness, of inverse iteration
};

}  // namespace brunt::comm
