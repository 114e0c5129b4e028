// SPDX-License-Identifier: Apache-2.0
// Linear systems over the ranks: the same bits as on one rank (direct), the same values (mumps).
#include "comm/linear_system.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "support/sparse_problems.hpp"

using namespace brunt;
using namespace brunt::test;
using comm::Communicator;
using comm::FactorStatus;
using comm::LinearMethod;
using comm::LinearSystem;

namespace {

constexpr double agreement = 1e-8;  // what parallel solutions promise

/// Rows dealt out in unequal, interleaved runs; the last of several ranks gets none.
std::vector<GlobalIndex> dealt_rows(const Communicator& ranks, GlobalIndex unknowns) {
  const int takers = std::max(1, ranks.size() - 1);
  std::vector<GlobalIndex> owned;
  for (GlobalIndex row = 0; row < unknowns; ++row) {
    const auto taker = static_cast<int>((row / 7 + row / 50) % takers);
    if (taker == ranks.rank()) owned.push_back(row);
  }
  return owned;
}

/// Contiguous ranges, nearly equal.
std::vector<GlobalIndex> cut_rows(const Communicator& ranks, GlobalIndex unknowns) {
  std::vector<GlobalIndex> owned;
  for (GlobalIndex row = 0; row < unknowns; ++row)
    if (row * ranks.size() / unknowns == ranks.rank()) owned.push_back(row);
  return owned;
}

struct Solved {
  std::vector<GlobalIndex> owned;
  std::vector<double> x;
  double error = 0;
  double operations = 0;
};

Solved solve(const Communicator& ranks, LinearMethod method, const SparseMatrix& matrix,
             const std::vector<GlobalIndex>& owned) {
  LinearSystem system(ranks, method, static_cast<GlobalIndex>(matrix.size()), owned);
  const comm::Factorised done = system.factorise(rows_of(matrix, owned));
  REQUIRE(done.ok());
  Solved solved{owned, std::vector<double>(owned.size()), 0, done.operations};
  solved.error = system.solve(load_of(owned), solved.x);
  return solved;
}

std::vector<double> of_rows(const std::vector<double>& all, const std::vector<GlobalIndex>& rows) {
  std::vector<double> values;
  for (const GlobalIndex row : rows) values.push_back(all[static_cast<std::size_t>(row)]);
  return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::abs(a[i] - b[i]));
  return difference;
}

}  // namespace

TEST_CASE("gathered systems have the bits of one rank, parallel ones its values") {
  const Communicator ranks = Communicator::world();
  for (const SparseMatrix& matrix : {held_block(6), tied_blocks(6)}) {
    const auto unknowns = static_cast<GlobalIndex>(matrix.size());
    const Solved alone = solve(Communicator::self(), LinearMethod::direct, matrix, all_rows(matrix));
    for (const auto& owned : {dealt_rows(ranks, unknowns), cut_rows(ranks, unknowns)}) {
      const Solved direct = solve(ranks, LinearMethod::direct, matrix, owned);
      CHECK(direct.x == of_rows(alone.x, owned));
      CHECK(direct.error == alone.error);
      CHECK(solve(ranks, LinearMethod::direct, matrix, owned).x == direct.x);
      const Solved parallel = solve(ranks, LinearMethod::mumps, matrix, owned);
      CHECK(parallel.error < 1e-15);
      double size = 0;
      for (const double value : alone.x) size = std::max(size, std::abs(value));
      CHECK(largest_difference(parallel.x, direct.x) < agreement * size);
    }
  }
}

TEST_CASE("elimination costs the same on many ranks") {
  const Communicator ranks = Communicator::world();
  const SparseMatrix matrix = held_block(10);
  const std::vector<GlobalIndex> owned = dealt_rows(ranks, static_cast<GlobalIndex>(matrix.size()));
  const double alone = solve(Communicator::self(), LinearMethod::direct, matrix, all_rows(matrix)).operations;
  CHECK(alone > 0);
  // METIS orders rows that are numbered differently: boxes of 16^3 and 31^3 elements are 2 and 0.5 % apart on two ranks
  CHECK(solve(ranks, LinearMethod::mumps, matrix, owned).operations == Approx(alone).epsilon(0.2));
  CHECK(solve(ranks, LinearMethod::direct, matrix, owned).operations == alone);
}

TEST_CASE("patterns that change, on ranks") {
  const Communicator ranks = Communicator::world();
  const SparseMatrix tied = tied_blocks(4);
  SparseMatrix opened = tied;  // one multiplier is off; its rows live on some rank
  const std::size_t off = tied.size() - 5;
  for (const auto& [column, value] : tied[off])
    opened[static_cast<std::size_t>(column)].erase(static_cast<GlobalIndex>(off));
  opened[off] = {{static_cast<GlobalIndex>(off), 1.0}};
  const std::vector<GlobalIndex> owned = dealt_rows(ranks, static_cast<GlobalIndex>(tied.size()));
  const std::vector<double> load = load_of(owned);
  for (const LinearMethod method : {LinearMethod::direct, LinearMethod::mumps}) {
    LinearSystem system(ranks, method, static_cast<GlobalIndex>(tied.size()), owned);
    std::vector<double> first(owned.size()), x(owned.size());
    REQUIRE(system.factorise(rows_of(tied, owned)).ok());
    system.solve(load, first);
    CHECK_FALSE(system.factorise(rows_of(tied, owned)).analysed);
    CHECK(system.factorise(rows_of(opened, owned)).analysed);
    system.solve(load, x);
    CHECK(ranks.max(largest_difference(x, first)) > 1e-6);
    CHECK(system.factorise(rows_of(tied, owned)).analysed);
    system.solve(load, x);
    if (method == LinearMethod::direct) CHECK(x == first);
    CHECK(largest_difference(x, first) < agreement);
  }
}

TEST_CASE("a block that floats is named on all ranks, with the same directions") {
  const Communicator ranks = Communicator::world();
  SparseMatrix matrix;
  add_block(matrix, {.elements = {3, 3, 3}, .held = true});
  const GlobalIndex second = add_block(matrix, {.elements = {3, 3, 4}, .modulus = 1e3});
  const auto unknowns = static_cast<GlobalIndex>(matrix.size());
  LinearSystem alone(Communicator::self(), LinearMethod::direct, unknowns, all_rows(matrix));
  REQUIRE(alone.factorise(rows_of(matrix, all_rows(matrix))).status == FactorStatus::singular);
  const std::vector<GlobalIndex> owned = dealt_rows(ranks, unknowns);
  for (const LinearMethod method : {LinearMethod::direct, LinearMethod::mumps}) {
    LinearSystem system(ranks, method, unknowns, owned);
    const comm::Factorised done = system.factorise(rows_of(matrix, owned));
    REQUIRE(done.status == FactorStatus::singular);
    CHECK(done.null_pivots == 6);
    for (GlobalIndex which = 0; which < done.null_pivots; ++which) {
      const std::vector<double> direction = system.null_direction(which);
      REQUIRE(direction.size() == owned.size());
      double held = 0, floating = 0;
      for (std::size_t i = 0; i < owned.size(); ++i) {
        double& largest = owned[i] < second ? held : floating;
        largest = std::max(largest, std::abs(direction[i]));
      }
      CHECK(ranks.max(held) < 1e-12);
      CHECK(ranks.max(floating) == 1);
      if (method == LinearMethod::direct) CHECK(direction == of_rows(alone.null_direction(which), owned));
    }
  }
}

TEST_CASE("what is not finite on one rank is refused on all") {
  const Communicator ranks = Communicator::world();
  SparseMatrix matrix = held_block(3);
  const std::vector<GlobalIndex> owned = dealt_rows(ranks, static_cast<GlobalIndex>(matrix.size()));
  for (const LinearMethod method : {LinearMethod::direct, LinearMethod::mumps}) {
    LinearSystem system(ranks, method, static_cast<GlobalIndex>(matrix.size()), owned);
    REQUIRE(system.factorise(rows_of(matrix, owned)).ok());
    std::vector<double> load = load_of(owned), x(owned.size());
    if (!load.empty() && owned.front() == 0) load.front() = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(system.solve(load, x), GuardError);
    SparseMatrix bad = matrix;
    bad[60].begin()->second = std::nan("");
    const comm::Factorised done = system.factorise(rows_of(bad, owned));
    CHECK(done.status == FactorStatus::not_finite);
    CHECK(done.row == 60);
  }
}

TEST_CASE("each row has one owner, or every rank hears of it") {
  const Communicator ranks = Communicator::world();
  std::vector<GlobalIndex> owned = cut_rows(ranks, 100);
  if (owned.front() == 0) owned.erase(owned.begin());
  CHECK_THROWS(LinearSystem(ranks, LinearMethod::direct, 100, owned));
  if (ranks.size() > 1) CHECK_THROWS(LinearSystem(ranks, LinearMethod::mumps, 2, std::vector<GlobalIndex>{0, 1}));
}
