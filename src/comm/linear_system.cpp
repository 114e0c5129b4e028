// SPDX-License-Identifier: Apache-2.0
#include "comm/linear_system.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "bytes.hpp"
#include "core/error.hpp"
#include "one_thread.hpp"
#include "row_layout.hpp"
#include "sparse_factors.hpp"

namespace brunt::comm {
namespace {

/// Checks that each unknown has exactly one owner.
void demand_each_row_once(const Communicator& ranks, GlobalIndex unknowns, std::span<const GlobalIndex> owned) {
  const bool ascend = std::ranges::is_sorted(owned, std::less_equal<>{});
  const bool inside = owned.empty() || (owned.front() >= 0 && owned.back() < unknowns);
  demand(!ranks.any(!ascend || !inside), "owned rows ascend and are rows of the matrix");
  bool once = true;
  std::vector<char> seen(ranks.is_root() ? static_cast<std::size_t>(unknowns) : 0);
  for (const std::vector<std::byte>& bytes : ranks.gather(std::as_bytes(owned)))
    for (const GlobalIndex row : array_of<GlobalIndex>(bytes)) once = nth(seen, row)++ == 0 && once;
  once = once && std::ranges::count(seen, 0) == 0;
  demand(!ranks.any(!once), "each row of the matrix has one owner");
}

void demand_rows(const SparseRows& rows, std::span<const GlobalIndex> owned, GlobalIndex unknowns) {
  demand(std::ranges::equal(rows.row, owned), "the rows of the matrix are those that this rank owns");
  demand(rows.begin.size() == owned.size() + 1 && rows.begin.front() == 0, "each row of the matrix has a begin");
  const auto entries = static_cast<std::size_t>(rows.begin.back());
  demand(rows.column.size() == entries && rows.value.size() == entries, "each entry has its column and its value");
  for (std::size_t i = 0; i < owned.size(); ++i) {
    GlobalIndex before = -1;
    for (auto k = static_cast<std::size_t>(rows.begin[i]); k < static_cast<std::size_t>(rows.begin[i + 1]); ++k) {
      demand(rows.column[k] > before && rows.column[k] < unknowns, "columns ascend within a row");
      before = rows.column[k];
    }
  }
}

constexpr GlobalIndex none = std::numeric_limits<GlobalIndex>::max();

GlobalIndex first_not_finite(const Communicator& ranks, const SparseRows& rows) {
  GlobalIndex found = none;
  for (std::size_t i = 0; i < rows.row.size() && found == none; ++i)
    for (auto k = static_cast<std::size_t>(rows.begin[i]); k < static_cast<std::size_t>(rows.begin[i + 1]); ++k)
      if (!std::isfinite(rows.value[k])) found = rows.row[i];
  return -ranks.max(-found);
}

/// Broadcasts the result of the root.
void share(const Communicator& ranks, Factorised& done) {
  struct Found {
    double memory, operations;
    GlobalIndex null_pivots;
    FactorStatus status;
    bool analysed;
  };
  Found found{done.memory, done.operations, done.null_pivots, done.status, done.analysed};
  const auto raw = std::as_bytes(std::span(&found, 1));
  std::vector<std::byte> bytes(raw.begin(), raw.end());
  ranks.broadcast(bytes);
  found = array_of<Found>(bytes).front();
  done.memory = found.memory;
  done.operations = found.operations;
  done.null_pivots = found.null_pivots;
  done.status = found.status;
  done.analysed = found.analysed;
  ranks.broadcast(done.message);
}

}  // namespace

struct LinearSystem::Solver {
  Communicator ranks;
  GlobalIndex unknowns;
  std::vector<GlobalIndex> owned;
  std::unique_ptr<RowLayout> layout;
  std::unique_ptr<SparseFactors> factors;  // null on ranks without rows of the solver
  std::optional<Factorised> last;

  [[nodiscard]] bool is(FactorStatus status) const { return last && last->status == status; }
};

LinearSystem::LinearSystem(const Communicator& ranks, LinearMethod method, GlobalIndex unknowns,
                           std::span<const GlobalIndex> owned_rows)
    : solver_(std::make_shared<Solver>(Solver{ranks, unknowns, {}, {}, {}, {}})) {
  demand(unknowns > 0 && unknowns < std::numeric_limits<SolverIndex>::max(),
         "a linear system has 1 to 2^31 - 1 unknowns");
  demand_each_row_once(ranks, unknowns, owned_rows);
  keep_blas_on_one_thread();
  solver_->owned.assign(owned_rows.begin(), owned_rows.end());
  const auto lay = method == LinearMethod::direct ? gathered_rows : renumbered_rows;
  solver_->layout = lay(ranks, unknowns, owned_rows);
  if (const MPI_Comm comm = solver_->layout->solver_ranks(); comm != MPI_COMM_NULL)
    solver_->factors = std::make_unique<SparseFactors>(comm);
}

Factorised LinearSystem::factorise(const SparseRows& rows) {
  const auto start = std::chrono::steady_clock::now();
  Solver& own = *solver_;
  demand_rows(rows, own.owned, own.unknowns);
  Factorised done;
  const GlobalIndex entries = own.ranks.sum(static_cast<GlobalIndex>(rows.value.size()));
  if (const GlobalIndex row = first_not_finite(own.ranks, rows); row != none) {
    done.status = FactorStatus::not_finite;
    done.row = row;
  } else if (entries > std::numeric_limits<SolverIndex>::max()) {
    done.status = FactorStatus::out_of_memory;
    done.message = "the matrix has " + std::to_string(entries) + " entries, more than 2^31 - 1";
  } else {
    RowRange range;
    const bool same_pattern = own.layout->to_solver(rows, range);
    if (own.factors) done = own.factors->factorise(std::move(range), same_pattern);
    share(own.ranks, done);
  }
  own.last = done;
  done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return done;
}

double LinearSystem::solve(std::span<const double> rhs, std::span<double> x) {
  Solver& own = *solver_;
  demand(own.is(FactorStatus::done), "a linear system is solved after it was factorised");
  demand(rhs.size() == own.owned.size() && x.size() == rhs.size(), "a right-hand side has a value for each owned row");
  const std::vector<double> b = own.layout->to_solver(rhs);
  std::vector<double> solution(b.size());
  double error = 0;
  std::string failure;
  if (own.factors) {
    try {
      error = own.factors->solve(b, solution);
    } catch (const MachineError& failed) {
      failure = failed.what();
    }
  }
  if (own.ranks.any(!failure.empty())) throw MachineError(failure.empty() ? "a linear solve failed" : failure);
  own.layout->from_solver(solution, x);
  error = own.ranks.max(error);
  if (std::isnan(error)) throw GuardError("the solution of a linear system is not finite");
  return error;
}

std::vector<double> LinearSystem::null_direction(GlobalIndex which) {
  Solver& own = *solver_;
  demand(which >= 0, "null directions count from 0");
  if (!own.is(FactorStatus::singular) || which >= own.last->null_pivots) return {};
  std::vector<double> direction;
  if (own.factors) {
    try {
      direction = own.factors->null_vector(which);
    } catch (const MachineError&) {
      direction.clear();
    }
  }
  if (!own.ranks.any(!direction.empty())) return {};
  std::vector<double> values(own.owned.size());
  own.layout->from_solver(direction, values);
  return values;
}

}  // namespace brunt::comm
