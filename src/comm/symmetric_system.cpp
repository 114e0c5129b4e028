// SPDX-License-Identifier: Apache-2.0
#include "comm/symmetric_system.hpp"

#include <new>
#include <vector>

#include "core/error.hpp"
#include "mumps.hpp"
#include "one_thread.hpp"
#include "row_layout.hpp"

namespace brunt::comm {

struct SymmetricSystem::Solver {
  Communicator ranks;
  std::unique_ptr<RowLayout> layout;
  std::unique_ptr<Mumps> factors;  // null on ranks without rows of the solver

  [[nodiscard]] bool takes_part() const { return layout->solver_ranks() != MPI_COMM_NULL; }
  Inertia factorise(const RowRange& range, bool same_pattern);
};

/// On the ranks that take part.
Inertia SymmetricSystem::Solver::factorise(const RowRange& range, bool same_pattern) {
  constexpr double no_null_pivots = 0;
  if (!same_pattern) factors.reset();
  Inertia inertia;
  try {
    for (const int more_room : Mumps::rooms) {
      if (factors == nullptr) {
        factors = std::make_unique<Mumps>(layout->solver_ranks(), Mumps::Kind::symmetric);
        factors->analyse(range, more_room);
      }
      if (factors->status() >= 0) factors->factorise(range, no_null_pivots);
      if (const int status = factors->status(); status >= 0) return {true, factors->negative_pivots(), {}};
      inertia.message =
          "MUMPS: error " + std::to_string(factors->status()) + " (" + std::to_string(factors->detail()) + ")";
      const bool again = factors->lacks_room();
      factors.reset();
      if (!again) break;
    }
  } catch (const MachineError& failure) {
    factors.reset();
    inertia.message = failure.what();
  } catch (const std::bad_alloc&) {
    factors.reset();
    inertia.message = "no memory for the rows of the matrix";
  }
  return inertia;
}

SymmetricSystem::SymmetricSystem(const Communicator& ranks, LinearMethod method, GlobalIndex unknowns,
                                 std::span<const GlobalIndex> owned_rows)
    : solver_(std::make_shared<Solver>(Solver{ranks, {}, {}})) {
  keep_blas_on_one_thread();
  const auto lay = method == LinearMethod::direct ? gathered_rows : renumbered_rows;
  solver_->layout = lay(ranks, unknowns, owned_rows);
}

Inertia SymmetricSystem::factorise(const SparseRows& rows) {
  Solver& own = *solver_;
  RowRange range;
  const bool same_pattern = own.layout->to_solver(rows, range);
  Inertia inertia;
  if (own.takes_part()) inertia = own.factorise(range, same_pattern);
  inertia.negative = own.ranks.max(inertia.negative);  // the root takes part
  inertia.found = own.ranks.any(inertia.found);
  own.ranks.broadcast(inertia.message);
  return inertia;
}

void SymmetricSystem::solve(std::span<const double> b, std::span<double> x) {
  Solver& own = *solver_;
  const std::vector<double> right = own.layout->to_solver(b);
  std::vector<double> solution(right.size());
  std::string failure;
  if (own.takes_part()) {
    try {
      own.factors->solve(right, solution);
    } catch (const MachineError& failed) {
      failure = failed.what();
    }
  }
  if (own.ranks.any(!failure.empty())) throw MachineError(failure.empty() ? "a linear solve failed" : failure);
  own.layout->from_solver(solution, x);
}

}  // namespace brunt::comm
