// SPDX-License-Identifier: Apache-2.0
#include "implicit/mortar/block_sums.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using implicit::BlockRow;

TEST_CASE("blocks of one column are added in the order in which they come, columns are sorted") {
  BlockRow row;
  const auto block = [](double value) -> Mat3 { return value * Mat3::Identity(); };
  row.add(7, block(1e16));
  row.add(3, block(2));
  row.add(7, block(1));
  row.add(7, block(-1e16));
  row.add(5, block(4));
  row.sort();
  REQUIRE(row.columns() == std::vector<GlobalIndex>{3, 5, 7});
  CHECK(row.block(0) == block(2));
  CHECK(row.block(1) == block(4));
  CHECK(row.block(2) == block(0));  // the 1 is lost in 1e16: another order would keep it
  row.clear();
  row.sort();
  CHECK(row.columns().empty());
}
