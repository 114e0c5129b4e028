// SPDX-License-Identifier: Apache-2.0
// What a halo does on one rank alone, and what it refuses.
#include "comm/halo.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace brunt;
using comm::Communicator;
using comm::Halo;
using comm::RemoteSlot;

TEST_CASE("on one rank a halo copies within the rank, root by root") {
  const std::vector<RemoteSlot> source{{0, 2}, {0, 0}, {0, 2}};
  const Halo halo(Communicator::self(), 3, source);
  CHECK(halo.roots() == 3);
  CHECK(halo.leaves() == 3);
  const std::vector<double> roots{1, 2, 3, 4, 5, 6};
  std::vector<double> leaves(6, -1.0);
  halo.forward(roots, leaves, 2);
  CHECK(leaves == std::vector<double>{5, 6, 1, 2, 5, 6});
}

TEST_CASE("a halo without roots or leaves does nothing") {
  const Halo nothing;
  CHECK(nothing.leaves() == 0);
  nothing.forward({}, {}, 3);
  const Halo empty(Communicator::self(), 0, {});
  empty.forward({}, {}, 3);
  empty.backward({}, {}, 1);
  CHECK(empty.roots() == 0);
}

TEST_CASE("a halo refuses sources that do not exist and arrays that are too short") {
  const Communicator self = Communicator::self();
  CHECK_THROWS(Halo(self, 2, std::vector<RemoteSlot>{{0, 2}}));
  CHECK_THROWS(Halo(self, 2, std::vector<RemoteSlot>{{0, -1}}));
  CHECK_THROWS(Halo(self, 2, std::vector<RemoteSlot>{{1, 0}}));
  const Halo halo(self, 2, std::vector<RemoteSlot>{{0, 1}});
  std::vector<double> roots(6), leaves(3), shorter(2);
  CHECK_THROWS(halo.forward(roots, shorter, 3));
  CHECK_THROWS(halo.forward(shorter, leaves, 3));
  CHECK_THROWS(halo.backward(shorter, roots, 3));
}
