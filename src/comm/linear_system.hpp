// SPDX-License-Identifier: Apache-2.0
// Direct solution of sparse linear systems A x = b over the ranks: the only interface to PETSc's matrices and to MUMPS.
// A may be unsymmetric and may have zeros on its diagonal (saddle point systems). Rows and unknowns have a canonical
// numbering 0 .. unknowns - 1, which depends on the problem and not on the ranks. Each row is complete on its owner.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "core/types.hpp"

namespace brunt::comm {

/// The rows of a square sparse matrix that this rank owns.
struct SparseRows {
  std::vector<GlobalIndex> row;     ///< ascending
  std::vector<std::int64_t> begin;  ///< row.size() + 1 offsets into column and value
  std::vector<GlobalIndex> column;  ///< ascending within a row; zero entries may be omitted
  std::vector<double> value;
};

enum class LinearMethod {
  direct,  ///< all rows on the root, factorised there: the same bits on any number of ranks and in every run
  mumps,   ///< factorised by all ranks: solutions agree up to rounding times the condition number, not bitwise
};

enum class FactorStatus {
  done,
  singular,       ///< pivots that are zero up to rounding; `null_direction` gives the unconstrained unknowns
  not_finite,     ///< the matrix contains an infinity or a NaN, first in row `row`
  out_of_memory,  ///< the factors do not fit
  failed,         ///< another failure of the library; `message` is its text
};

/// Equal on every rank, except `seconds`.
struct Factorised {
  FactorStatus status = FactorStatus::done;
  GlobalIndex null_pivots = 0;  ///< of `singular`: the dimension of the null space
  GlobalIndex row = -1;         ///< of `not_finite`
  double memory = 0;            ///< [bytes] of factors and work space on all ranks together
  double operations = 0;        ///< [flop] of the elimination on all ranks together
  double seconds = 0;           ///< [s] wall time of the call
  bool analysed = false;        ///< whether the elimination order was computed again (whenever the pattern changed)
  std::string message;          ///< of `failed` and `out_of_memory`

  [[nodiscard]] bool ok() const { return status == FactorStatus::done; }
};

/// Every member is collective.
class LinearSystem {
 public:
  /// Larger systems should use `mumps`: `direct` then needs minutes and tens of gigabytes on one rank in three
  /// dimensions.
  static constexpr GlobalIndex most_for_direct = 300'000;

  /// `owned_rows`, ascending, may be empty; each of the `unknowns` rows has exactly one owner.
  LinearSystem(const Communicator& ranks, LinearMethod method, GlobalIndex unknowns,
               std::span<const GlobalIndex> owned_rows);

  /// Factorises A and replaces the previous factors. `rows.row` are the owned rows; the pattern may change between
  /// calls. The bits of a solution depend on A and b only, not on earlier matrices. Does not throw for a matrix that
  /// cannot be factorised: see `Factorised`.
  [[nodiscard]] Factorised factorise(const SparseRows& rows);

  /// Solves A x = b with iterative refinement; values of the owned rows, in their order. Requires a `factorise` with
  /// result `ok`. Returns the largest |b - A x|_i / (|A| |x| + |b|)_i of all rows (about 1e-16 normally). Throws
  /// GuardError if b or x is not finite.
  double solve(std::span<const double> rhs, std::span<double> x);

  /// After `singular`: direction number `which` of `null_pivots` independent directions d with A d = 0, values of the
  /// owned rows, scaled to a largest entry of 1 over all ranks. Its large entries are the unconstrained unknowns. Empty
  /// if none was found.
  [[nodiscard]] std::vector<double> null_direction(GlobalIndex which = 0);

 private:
  struct Solver;
  std::shared_ptr<Solver> solver_;
};

}  // namespace brunt::comm
