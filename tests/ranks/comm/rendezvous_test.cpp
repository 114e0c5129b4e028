// SPDX-License-Identifier: Apache-2.0
// Messages to ranks found at run time, and the way to the block layout and back.
#include "comm/rendezvous.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace brunt;
using comm::BlockRedistribution;
using comm::Communicator;

TEST_CASE("every rank gets what every rank sent, by rank, in order") {
  const Communicator ranks = Communicator::world();
  std::vector<std::vector<GlobalIndex>> to_rank(static_cast<std::size_t>(ranks.size()));
  for (Rank r = 0; r < ranks.size(); ++r)
    for (int i = 0; i < (ranks.rank() + r) % 3; ++i)
      to_rank[static_cast<std::size_t>(r)].push_back(100 * ranks.rank() + 10 * r + i);
  const Ragged<GlobalIndex> got = comm::exchange(ranks, to_rank);
  REQUIRE(got.rows() == ranks.size());
  for (Rank r = 0; r < ranks.size(); ++r) {
    const auto row = got.row(r);
    REQUIRE(row.size() == static_cast<std::size_t>((ranks.rank() + r) % 3));
    for (std::size_t i = 0; i < row.size(); ++i)
      CHECK(row[i] == 100 * r + 10 * ranks.rank() + static_cast<GlobalIndex>(i));
  }
}

TEST_CASE("an exchange of nothing is an exchange") {
  const Communicator ranks = Communicator::world();
  const Ragged<int> got = comm::exchange(ranks, std::vector<std::vector<int>>(static_cast<std::size_t>(ranks.size())));
  CHECK(got.rows() == ranks.size());
  CHECK(got.values.empty());
}

TEST_CASE("values go to the block layout and come back") {
  const Communicator ranks = Communicator::world();
  constexpr int width = 2;
  for (const GlobalIndex total : {1, 10, 11}) {
    std::vector<GlobalIndex> ids;  // dealt out one by one, backwards
    for (GlobalIndex id = total - 1; id >= 0; --id)
      if (id % ranks.size() == ranks.rank()) ids.push_back(id);
    const BlockRedistribution redistribution(ranks, total, ids);
    std::vector<double> held;
    for (const GlobalIndex id : ids)
      for (int c = 0; c < width; ++c) held.push_back(10.0 * static_cast<double>(id) + c);

    const LocalIndex count = redistribution.layout().count(ranks.rank());
    std::vector<double> block(static_cast<std::size_t>(count) * width, -1.0);
    redistribution.to_blocks(held, block, width);
    for (LocalIndex i = 0; i < count; ++i)
      for (int c = 0; c < width; ++c)
        CHECK(block[static_cast<std::size_t>(i * width + c)] ==
              10.0 * static_cast<double>(redistribution.layout().first(ranks.rank()) + i) + c);

    std::vector<double> back(held.size(), -1.0);
    redistribution.from_blocks(block, back, width);
    CHECK(back == held);
  }
}
