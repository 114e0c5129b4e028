// SPDX-License-Identifier: Apache-2.0
// Records belong together by step, then by time; each has one partner at most.
#include "io/results/record_pairs.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using io::Instant;
using Both = std::vector<std::pair<std::size_t, std::size_t>>;

TEST_CASE("record pairs: by step, in A's order") {
  const std::vector<Instant> a{{0, 0}, {10, 1}, {30, 3}}, b{{0, 0}, {20, 2}, {30, 3.5}};
  const io::RecordPairs pairs = io::pair_records(a, b);
  CHECK(pairs.both == Both{{0, 0}, {2, 2}});
  CHECK(pairs.only_a == std::vector<std::size_t>{1});
  CHECK(pairs.only_b == std::vector<std::size_t>{1});
}

TEST_CASE("record pairs: the same times in half the steps") {
  const std::vector<Instant> a{{0, 0}, {10, 0.1 + 0.2}, {20, 0.6}}, b{{0, 0}, {5, 0.3}, {10, 0.6}, {15, 0.9}};
  const io::RecordPairs pairs = io::pair_records(a, b);
  // step 10 is in both and goes first, though at other times; what is left has no partner of its time
  CHECK(pairs.both == Both{{0, 0}, {1, 2}});
  const std::vector<Instant> odd{{0, 0}, {11, 0.1 + 0.2}, {21, 0.6}};
  CHECK(io::pair_records(odd, b).both == Both{{0, 0}, {1, 1}, {2, 2}});
  CHECK(io::pair_records(odd, b).only_b == std::vector<std::size_t>{3});
}

TEST_CASE("record pairs: a step that stands twice has two partners or stays alone") {
  const std::vector<Instant> twice{{4, 1}, {4, 1}}, once{{4, 1}};
  CHECK(io::pair_records(twice, twice).both.size() == 2);
  CHECK(io::pair_records(twice, once).only_a.size() == 1);
}

TEST_CASE("record pairs: what is missing is named, a long list is cut") {
  std::vector<Instant> many;
  for (GlobalIndex step = 1; step <= 20; ++step) many.push_back({step, 0.1 * static_cast<double>(step)});
  const std::vector<Instant> none;
  const auto lines = io::unpaired_lines(io::pair_records(many, none), many, none, "record");
  REQUIRE(lines.size() == 1);
  CHECK(lines[0] == "records: steps 1, 2, 3, 4, 5, 6, 7, 8, ... (20 in all) are only in A");
  const std::vector<Instant> other{{100, 50}};
  CHECK(io::unpaired_lines(io::pair_records(many, other), many, other, "record").front() ==
        "records: A and B have none of the same step or time");
}
