// SPDX-License-Identifier: Apache-2.0
// The block layout: every entity in one block, blocks equal but for one.
#include "comm/rendezvous.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"

using namespace brunt;
using comm::BlockLayout;

TEST_CASE("a block layout deals out every entity once, evenly") {
  for (const GlobalIndex total : {0, 1, 2, 7, 8, 100}) {
    for (const int ranks : {1, 2, 3, 7, 8, 9}) {
      const BlockLayout layout{total, ranks};
      CHECK(layout.first(0) == 0);
      CHECK(layout.first(ranks) == total);
      for (Rank r = 0; r < ranks; ++r) {
        CHECK(layout.count(r) - layout.count(ranks - 1) <= 1);
        for (GlobalIndex id = layout.first(r); id < layout.first(r + 1); ++id) CHECK(layout.owner(id) == r);
      }
    }
  }
}

TEST_CASE("a block layout knows no entity outside") {
  const BlockLayout layout{10, 3};
  CHECK_THROWS(layout.owner(-1));
  CHECK_THROWS(layout.owner(10));
}

TEST_CASE("an exchange wants a row for each rank") {
  const comm::Communicator self = comm::Communicator::self();
  CHECK_THROWS(comm::exchange_bytes(self, {}));
}
