// SPDX-License-Identifier: Apache-2.0
// Rows of a sparse matrix as required by a parallel solver: each rank has a contiguous range.
#pragma once
#include <cstdint>
#include <vector>

namespace brunt::comm {

/// MUMPS and METIS count unknowns and entries of a rank in 32 bits.
using SolverIndex = std::int32_t;

/// Rows of a contiguous range, in the numbers of the solver.
struct RowRange {
  SolverIndex unknowns = 0;         ///< of all ranks
  std::vector<SolverIndex> begin;   ///< rows of this rank + 1
  std::vector<SolverIndex> column;  ///< ascending within a row
  std::vector<double> value;

  [[nodiscard]] SolverIndex rows() const { return static_cast<SolverIndex>(begin.size()) - 1; }
};

}  // namespace brunt::comm
