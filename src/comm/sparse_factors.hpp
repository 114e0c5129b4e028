// SPDX-License-Identifier: Apache-2.0
// A sparse matrix of PETSc with its factors by MUMPS, on the ranks of an MPI communicator that each own a contiguous
// range of rows. On one rank the bits of every result depend on the matrix and the right-hand side alone.
#pragma once
#include <petscmat.h>

#include <span>
#include <vector>

#include "brunt/comm/linear_system.hpp"

namespace brunt::comm {

/// Rows of a contiguous range, in the numbers of PETSc.
struct RowRange {
  PetscInt unknowns = 0;         ///< of all ranks
  std::vector<PetscInt> begin;   ///< rows of this rank + 1
  std::vector<PetscInt> column;  ///< ascending within a row
  std::vector<double> value;

  [[nodiscard]] PetscInt rows() const { return static_cast<PetscInt>(begin.size()) - 1; }
};

class SparseFactors {
 public:
  explicit SparseFactors(MPI_Comm comm) : comm_(comm) {}
  ~SparseFactors();
  SparseFactors(const SparseFactors&) = delete;
  SparseFactors& operator=(const SparseFactors&) = delete;

  /// `same_pattern`: columns are those of the last call, on all ranks.
  Factorised factorise(RowRange&& rows, bool same_pattern);
  /// Refined x and its componentwise backward error; NaN if x is not finite.
  double solve(std::span<const double> b, std::span<double> x);
  std::vector<double> null_vector(GlobalIndex which);

 private:
  Factorised factorise_with_room(double null_pivot);
  Factorised factorise_with(PetscInt relaxation, double null_pivot);
  void analyse(PetscInt relaxation);
  void make_matrix();
  bool is_singular();
  /// What multiplies rows and columns of this rank until all of them have a largest entry near 1: equations of contact
  /// and pressures have units of their own, so rows and columns of one number are not alike.
  struct Equilibration {
    std::vector<double> row, column;
  };
  Equilibration equilibration();
  std::span<const double> of_all_ranks(std::span<const double> own);
  void free_factors();
  void substitute(std::span<const double> b, std::span<double> x);
  double residual(std::span<const double> b, std::span<const double> x, std::span<double> r);
  [[nodiscard]] PetscInt info(PetscInt which) const;

  MPI_Comm comm_;
  RowRange rows_;
  Mat matrix_ = nullptr;
  Mat factors_ = nullptr;
  Vec right_ = nullptr;
  Vec solution_ = nullptr;
  std::vector<double> of_all_;    // a vector's values of all ranks
  std::vector<double> floating_;  // a direction without stiffness, of inverse iteration
};

}  // namespace brunt::comm
