// SPDX-License-Identifier: Apache-2.0
// Which parts hold which nodes, on meshes small enough to number by hand.
#include "partition/sharing.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "unit/partition/meshes.hpp"

using namespace brunt;
using partition::share_nodes;
using partition::Sharing;

namespace {

std::vector<Rank> row(const Sharing& sharing, LocalIndex i) {
  const auto holders = sharing.holders.row(i);
  return {holders.begin(), holders.end()};
}

}  // namespace

TEST_CASE("a node belongs to the part of its first element; where parts meet both hold it") {
  const mesh::Mesh bar = partition::test::box({3, 1, 1});  // node i + 4 (j + 2 k): elements 0, 1, 2 meet at i = 1 and 2
  const std::vector<Rank> part{1, 0, 1};
  const Sharing sharing = share_nodes(bar, part);
  CHECK(sharing.owner == std::vector<Rank>{1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1});
  CHECK(sharing.shared == std::vector<LocalIndex>{1, 2, 5, 6, 9, 10, 13, 14});
  REQUIRE(sharing.holders.rows() == 8);
  for (LocalIndex i = 0; i < 8; ++i) CHECK(row(sharing, i) == std::vector<Rank>{0, 1});
}

TEST_CASE("parts around an edge hold it once each, in ascending order") {
  const mesh::Mesh plate = partition::test::box({2, 2, 1});  // the middle edge: nodes 4 and 13
  const Sharing sharing = share_nodes(plate, std::vector<Rank>{3, 1, 2, 1});
  CHECK(sharing.owner[4] == 3);
  CHECK(sharing.owner[13] == 3);
  const std::vector<LocalIndex> between{1, 3, 4, 7, 10, 12, 13, 16};  // but for node 5, where 1 meets 1
  REQUIRE(sharing.shared == between);
  CHECK(row(sharing, 0) == std::vector<Rank>{1, 3});
  CHECK(row(sharing, 1) == std::vector<Rank>{2, 3});
  CHECK(row(sharing, 2) == std::vector<Rank>{1, 2, 3});
  CHECK(row(sharing, 3) == std::vector<Rank>{1, 2});
}

TEST_CASE("one part shares nothing; a node without an element belongs to the first") {
  mesh::Mesh cube = partition::test::box({1, 1, 1});
  cube.coordinates.emplace_back(5, 5, 5);
  const Sharing sharing = share_nodes(cube, std::vector<Rank>{4});
  CHECK(sharing.owner == std::vector<Rank>{4, 4, 4, 4, 4, 4, 4, 4, 0});
  CHECK(sharing.shared.empty());
  CHECK(sharing.holders.rows() == 0);
}
