// SPDX-License-Identifier: Apache-2.0
// L D L^T of a sparse symmetric matrix S over the ranks, with its inertia (Sylvester): D has as many negative
// eigenvalues as S. S may be indefinite and may have zeros on its diagonal (saddle point systems).
#pragma once
#include <memory>
#include <span>
#include <string>

#include "comm/linear_system.hpp"

namespace brunt::comm {

/// Equal on every rank.
struct Inertia {
  bool found = false;        ///< whether the matrix could be factorised
  GlobalIndex negative = 0;  ///< number of negative eigenvalues
  std::string message;       ///< of a failure
};

/// Every member is collective.
class SymmetricSystem {
 public:
  /// As LinearSystem: `direct` gives the same bits on any number of ranks.
  SymmetricSystem(const Communicator& ranks, LinearMethod method, GlobalIndex unknowns,
                  std::span<const GlobalIndex> owned_rows);

  /// S_ij = A_ij + A_ji for i != j, and S_ii = A_ii, with the given rows A.
  [[nodiscard]] Inertia factorise(const SparseRows& rows);

  /// Solves S x = b with the last factors: values of the owned rows.
  void solve(std::span<const double> b, std::span<double> x);

 private:
  struct Solver;
  std::shared_ptr<Solver> solver_;
};

}  // namespace brunt::comm
