// SPDX-License-Identifier: Apache-2.0
// Reductions and transfers of the communicator on any number of ranks.
#include "comm/communicator.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace brunt;
using comm::Communicator;

namespace {

std::vector<std::byte> repeated(std::size_t count, int value) {
  return std::vector<std::byte>(count, static_cast<std::byte>(value));
}

}  // namespace

TEST_CASE("maxima, minima and sums over ranks") {
  const Communicator ranks = Communicator::world();
  const int n = ranks.size();
  CHECK(ranks.max(-1.5 - ranks.rank()) == -1.5);
  CHECK(ranks.min(-1.5 - ranks.rank()) == -0.5 - n);
  std::vector<double> values{0.5 * ranks.rank(), -0.5 * ranks.rank(), -1.0e300};
  ranks.max(values);
  CHECK(values == std::vector<double>{0.5 * (n - 1), 0.0, -1.0e300});
  CHECK(ranks.sum(GlobalIndex{1} << ranks.rank()) == (GlobalIndex{1} << n) - 1);
  CHECK(ranks.max(GlobalIndex{ranks.rank()} - 5) == n - 6);
  CHECK(ranks.sum_before(ranks.rank() + 1) == ranks.rank() * (ranks.rank() + 1) / 2);
  CHECK(ranks.any(ranks.rank() == n - 1));
  CHECK_FALSE(ranks.any(false));
}

TEST_CASE("the sum of integers wraps modulo 2^64") {
  const Communicator ranks = Communicator::world();
  std::vector<GlobalIndex> values{ranks.is_root() ? std::numeric_limits<GlobalIndex>::max() : 1};
  ranks.sum(values);
  const auto expected = static_cast<std::uint64_t>(std::numeric_limits<GlobalIndex>::max()) +
                        static_cast<std::uint64_t>(ranks.size() - 1);
  CHECK(static_cast<std::uint64_t>(values[0]) == expected);
}

TEST_CASE("a maximum that travels while others do") {
  const Communicator ranks = Communicator::world();
  const double last = ranks.size() - 1;
  for (int again = 0; again < 2; ++again) {
    std::array<double, 3> values{static_cast<double>(ranks.rank()), -static_cast<double>(ranks.rank()), std::nan("")};
    ranks.begin_max(values);
    CHECK(ranks.sum(GlobalIndex{1}) == ranks.size());
    ranks.end_max(values);
    CHECK(values[0] == last);
    CHECK(values[1] == 0);
    CHECK(std::isnan(values[2]));
  }
}

TEST_CASE("a NaN of one rank reaches all, infinities keep their order") {
  const Communicator ranks = Communicator::world();
  const bool is_last = ranks.rank() == ranks.size() - 1;
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(ranks.max(is_last ? std::nan("") : infinity)));
  CHECK(std::isnan(ranks.min(is_last ? -std::nan("") : -1.0)));
  CHECK(ranks.max(is_last ? infinity : 1.0e308) == infinity);
  CHECK(ranks.min(is_last ? -infinity : -1.0e308) == -infinity);
}

TEST_CASE("bytes and text reach every rank, also none at all") {
  const Communicator ranks = Communicator::world();
  std::string text = ranks.is_root() ? "brunt" : "something longer";
  ranks.broadcast(text);
  CHECK(text == "brunt");
  std::vector<std::byte> bytes = ranks.is_root() ? repeated(0, 0) : repeated(3, 1);
  ranks.broadcast(bytes);
  CHECK(bytes.empty());
}

TEST_CASE("gather brings, scatter deals out, by rank") {
  const Communicator ranks = Communicator::world();
  const auto own = static_cast<std::size_t>(ranks.rank());
  const std::vector<std::vector<std::byte>> gathered = ranks.gather(repeated(own, ranks.rank()));
  if (ranks.is_root()) {
    REQUIRE(gathered.size() == static_cast<std::size_t>(ranks.size()));
    for (int r = 0; r < ranks.size(); ++r)
      CHECK(gathered[static_cast<std::size_t>(r)] == repeated(static_cast<std::size_t>(r), r));
  } else {
    CHECK(gathered.empty());
  }
  const std::vector<std::byte> dealt =
      ranks.scatter([](Rank r) { return repeated(2 * static_cast<std::size_t>(r), r + 1); });
  CHECK(dealt == repeated(2 * own, ranks.rank() + 1));
  const std::vector<double> all = ranks.gather_all(0.25 * ranks.rank());
  for (std::size_t r = 0; r < all.size(); ++r) CHECK(all[r] == 0.25 * static_cast<double>(r));
}
