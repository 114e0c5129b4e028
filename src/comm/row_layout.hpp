// SPDX-License-Identifier: Apache-2.0
// Mapping of the rows that ranks own, and of vectors, to the rows of a solver: all on the root in canonical order, or
// each rank's own rows after those of the lower ranks. Every member is collective.
#pragma once
#include <mpi.h>

#include <memory>
#include <span>
#include <vector>

#include "comm/linear_system.hpp"
#include "row_range.hpp"

namespace brunt::comm {

class RowLayout {
 public:
  virtual ~RowLayout() = default;
  /// The solver's communicator; MPI_COMM_NULL on ranks that do not take part.
  [[nodiscard]] virtual MPI_Comm solver_ranks() const = 0;
  /// The rows of this rank in the solver's numbers, and whether their columns are unchanged since the last call (on all
  /// ranks).
  virtual bool to_solver(const SparseRows& rows, RowRange& range) = 0;
  [[nodiscard]] virtual std::vector<double> to_solver(std::span<const double> owned) const = 0;
  virtual void from_solver(std::span<const double> values, std::span<double> owned) const = 0;
};

std::unique_ptr<RowLayout> gathered_rows(const Communicator& ranks, GlobalIndex unknowns,
                                         std::span<const GlobalIndex> owned_rows);
std::unique_ptr<RowLayout> renumbered_rows(const Communicator& ranks, GlobalIndex unknowns,
                                           std::span<const GlobalIndex> owned_rows);

}  // namespace brunt::comm
