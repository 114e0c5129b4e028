// SPDX-License-Identifier: Apache-2.0
// Exact sums over ranks: the same bits however the values are dealt out.
#include "comm/exact_sum.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace brunt;
using comm::Communicator;
using comm::ExactAccumulator;

namespace {

std::vector<double> wild_values() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-80, 80);
  std::vector<double> values(1000);
  for (double& value : values) value = std::ldexp(mantissa(random), exponent(random));
  return values;
}

}  // namespace

TEST_CASE("an exact sum has the bits of the one-rank sum, with ranks that bring nothing") {
  const Communicator ranks = Communicator::world();
  const std::vector<double> values = wild_values();
  const double alone = comm::exact_sum(Communicator::self(), values);
  for (const int working : {1, 2, ranks.size()}) {
    std::vector<double> own;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (static_cast<int>(i) % std::min(working, ranks.size()) == ranks.rank()) own.push_back(values[i]);
    CHECK(comm::exact_sum(ranks, own) == alone);
  }
}

TEST_CASE("several sums go in one message and leave the accumulators as they were") {
  const Communicator ranks = Communicator::world();
  std::array<ExactAccumulator, 3> sums;
  sums[0].add(ranks.is_root() ? 1.0e300 : 0.0);
  sums[0].add(0.5);
  sums[0].add(ranks.rank() == ranks.size() - 1 ? -1.0e300 : 0.0);
  sums[1].add(-1.0);
  sums[2].add(ranks.is_root() ? std::numeric_limits<double>::infinity() : 1.0);
  std::array<double, 3> results{};
  for (int repeat = 0; repeat < 2; ++repeat) {
    comm::exact_sum(ranks, sums, results);
    CHECK(results[0] == 0.5 * ranks.size());
    CHECK(results[1] == -ranks.size());
    CHECK(std::isnan(results[2]));
  }
}
