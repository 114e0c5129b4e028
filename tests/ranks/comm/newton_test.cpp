// SPDX-License-Identifier: Apache-2.0
// Newton's iteration over the ranks, with a linear system and exact sums: the same bits on any number of ranks.
#include "comm/newton.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "comm/linear_system.hpp"
#include "support/sparse_problems.hpp"

using namespace brunt;
using namespace brunt::test;
using comm::Communicator;
using comm::NewtonReason;
using comm::NewtonVerdict;

namespace {

using Values = std::span<const double>;

/// Springs in a chain that stiffen, the last end pulled: k (u_i - u_{i-1}) (1 + (u_i - u_{i-1})^2) = f. A rank knows
/// the whole chain by the owners' exchange that a maximum over ranks is here.
struct Chain {
  const Communicator& ranks;
  std::vector<GlobalIndex> owned;
  GlobalIndex count = 40;
  double pull = 0.9 * 1.81;
  std::vector<double> sizes{};

  [[nodiscard]] std::vector<double> whole(Values x) const {
    std::vector<double> all(static_cast<std::size_t>(count), -1e300);
    for (std::size_t i = 0; i < owned.size(); ++i) all[static_cast<std::size_t>(owned[i])] = x[i];
    ranks.max(all);
    return all;
  }
  [[nodiscard]] double stretch(const std::vector<double>& u, GlobalIndex spring) const {
    if (spring >= count) return 0;
    const auto i = static_cast<std::size_t>(spring);
    return u[i] - (i > 0 ? u[i - 1] : 0.0);
  }
  bool residual(Values x, std::span<double> r) const {
    const std::vector<double> u = whole(x);
    const auto force = [&](GlobalIndex s) { return stretch(u, s) * (1 + stretch(u, s) * stretch(u, s)); };
    for (std::size_t i = 0; i < owned.size(); ++i)
      r[i] = force(owned[i]) - force(owned[i] + 1) - (owned[i] == count - 1 ? pull : 0.0);
    return true;
  }
  [[nodiscard]] comm::SparseRows tangent(Values x) const {
    const std::vector<double> u = whole(x);
    SparseMatrix matrix(static_cast<std::size_t>(count));
    for (GlobalIndex s = 0; s < count; ++s) {
      const double slope = 1 + 3 * stretch(u, s) * stretch(u, s);
      matrix[static_cast<std::size_t>(s)][s] += slope;
      if (s == 0) continue;
      matrix[static_cast<std::size_t>(s - 1)][s - 1] += slope;
      matrix[static_cast<std::size_t>(s - 1)][s] -= slope;
      matrix[static_cast<std::size_t>(s)][s - 1] -= slope;
    }
    return rows_of(matrix, owned);
  }
};

std::vector<GlobalIndex> every_nth(const Communicator& ranks, GlobalIndex count) {
  std::vector<GlobalIndex> owned;  // the last of several ranks owns none
  const GlobalIndex takers = std::max(1, ranks.size() - 1);
  for (GlobalIndex row = 0; row < count; ++row)
    if (row % takers == ranks.rank()) owned.push_back(row);
  return owned;
}

std::vector<double> pulled(Chain& chain, comm::NewtonResult& result) {
  comm::LinearSystem system(chain.ranks, comm::LinearMethod::direct, chain.count, chain.owned);
  comm::NewtonProblem problem;
  problem.residual = [&](Values x, std::span<double> r) { return chain.residual(x, r); };
  problem.solve = [&](Values x, Values r, std::span<double> c) {
    if (!system.factorise(chain.tangent(x)).ok()) return false;
    system.solve(r, c);
    return true;
  };
  problem.judge = [&](int iteration, Values, Values r) {
    double size = 0;
    for (const double value : r) size = std::max(size, std::abs(value));
    chain.sizes.push_back(chain.ranks.max(size));
    if (chain.sizes.back() < 1e-13) return NewtonVerdict::converged;
    return iteration < 50 ? NewtonVerdict::go_on : NewtonVerdict::give_up;
  };
  problem.step_length = [&](const comm::NewtonStep& step) {
    std::vector<double> trial(chain.owned.size());
    double share = 1;
    for (; share > 0.01; share /= 2) {
      double size = 0;
      step.residual_at(share, trial);
      for (const double value : trial) size = std::max(size, std::abs(value));
      if (chain.ranks.max(size) < chain.sizes.back()) break;
    }
    return share;
  };
  std::vector<double> x(chain.owned.size());
  result = comm::newton(chain.ranks, x, problem);
  return x;
}

}  // namespace

TEST_CASE("a chain that stiffens: the same iterates on any ranks, quadratic at the end") {
  const Communicator world = Communicator::world(), self = Communicator::self();
  Chain chain{world, every_nth(world, 40)}, alone{self, every_nth(self, 40)};
  comm::NewtonResult result, result_alone;
  const std::vector<double> x = pulled(chain, result), x_alone = pulled(alone, result_alone);
  CHECK(result.reason == NewtonReason::converged);
  CHECK(result.iterations == result_alone.iterations);
  CHECK(chain.sizes == alone.sizes);
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(x[i] == x_alone[static_cast<std::size_t>(chain.owned[i])]);
    // every spring carries the pull, s (1 + s^2) of s = 0.9
    CHECK(x[i] == Approx(0.9 * static_cast<double>(chain.owned[i] + 1)).epsilon(1e-12));
  }
  const auto last = chain.sizes.size() - 1;
  CHECK(chain.sizes[last - 1] < 3 * chain.sizes[last - 2] * chain.sizes[last - 2]);
}

TEST_CASE("an exception on all ranks comes out on all ranks") {
  const Communicator world = Communicator::world();
  Chain chain{world, every_nth(world, 40)};
  comm::NewtonProblem problem;
  problem.residual = [&](Values x, std::span<double> r) { return chain.residual(x, r); };
  problem.solve = [](Values, Values, std::span<double>) -> bool { throw std::out_of_range("all of us"); };
  problem.judge = [](int, Values, Values) { return NewtonVerdict::go_on; };
  std::vector<double> x(chain.owned.size());
  CHECK_THROWS_AS(comm::newton(world, x, problem), std::out_of_range);
  CHECK(world.sum(GlobalIndex{1}) == world.size());
}
