// SPDX-License-Identifier: Apache-2.0
// Sparse linear systems A x = b over the ranks, solved directly: the one face of MUMPS.
// A may be unsymmetric and may have zeros on its diagonal (saddle point systems). Rows and unknowns are numbered
// canonically, 0 .. unknowns - 1, a function of the problem and not of the ranks, and each row is complete on its
// owner.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/core/types.hpp"

namespace brunt::comm {

/// The rows of a square sparse matrix that this rank owns.
struct SparseRows {
  std::vector<GlobalIndex> row;     ///< ascending
  std::vector<std::int64_t> begin;  ///< row.size() + 1 offsets into column and value
  std::vector<GlobalIndex> column;  ///< ascending within a row; entries that are zero may be left out
  std::vector<double> value;
};

enum class LinearMethod {
  direct,  ///< all rows on the root, factorised there: the same bits on any number of ranks and in every run
  mumps,   ///< factorised by all ranks: solutions agree to rounding times the condition, their bits do not
};

enum class FactorStatus {
  done,
  singular,       ///< pivots that are zero but for rounding; `null_direction` tells which unknowns float
  not_finite,     ///< the matrix holds an infinity or a NaN, first in row `row`
  out_of_memory,  ///< the factors do not fit
  failed,         ///< the library gave up otherwise; `message` is what it said
};

/// The same on every rank, but for `seconds`.
struct Factorised {
  FactorStatus status = FactorStatus::done;
  GlobalIndex null_pivots = 0;  ///< of `singular`: the dimension of the null space
  GlobalIndex row = -1;         ///< of `not_finite`
  double memory = 0;            ///< [bytes] that factors and work space take, of all ranks together
  double operations = 0;        ///< [flop] of the elimination, of all ranks together
  double seconds = 0;           ///< [s] wall time of the call
  bool analysed = false;        ///< whether elimination was ordered anew (it is where the pattern changed)
  std::string message;          ///< of `failed` and `out_of_memory`

  [[nodiscard]] bool ok() const { return status == FactorStatus::done; }
};

/// Every member is collective.
class LinearSystem {
 public:
  /// More unknowns than this want `mumps`: one rank then takes minutes and tens of gigabytes in three dimensions.
  static constexpr GlobalIndex most_for_direct = 300'000;

  /// `owned_rows`, ascending, may be empty; each of the `unknowns` rows has exactly one owner.
  LinearSystem(const Communicator& ranks, LinearMethod method, GlobalIndex unknowns,
               std::span<const GlobalIndex> owned_rows);

  /// Takes A and replaces the last factors. `rows.row` are the owned rows; the pattern may change from call to call.
  /// The bits of a solution depend on A and b alone, not on the matrices before. Does not throw for a matrix that
  /// cannot be factorised: see `Factorised`.
  [[nodiscard]] Factorised factorise(const SparseRows& rows);

  /// x of A x = b, refined against the residual; values of the owned rows, in their order. After a `factorise` that is
  /// `ok`. Returns the largest |b - A x|_i / (|A| |x| + |b|)_i of all rows (some 1e-16 where nothing is wrong).
  /// Throws GuardError if b or x is not finite.
  double solve(std::span<const double> rhs, std::span<double> x);

  /// After `singular`: the `which`-th of `null_pivots` independent directions d with A d = 0, values of the owned rows,
  /// the largest of all ranks 1. Its large entries are the unknowns that float. Empty if none was found.
  [[nodiscard]] std::vector<double> null_direction(GlobalIndex which = 0);

 private:
  struct Solver;
  std::shared_ptr<Solver> solver_;
};

}  // namespace brunt::comm
