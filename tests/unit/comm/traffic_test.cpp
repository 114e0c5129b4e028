// SPDX-License-Identifier: Apache-2.0
// Sums and differences of counters; on one rank nothing is sent.
#include "comm/traffic.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "comm/halo.hpp"

using namespace brunt;
using comm::Traffic;

TEST_CASE("traffic adds and subtracts kind by kind") {
  const Traffic a{{5, 50}, {3, 30}, {7, 70}}, b{{1, 10}, {2, 20}, {4, 40}};
  const Traffic less = a - b, again = less + b;
  CHECK(less.halo.messages == 4);
  CHECK(less.halo.bytes == 40);
  CHECK(less.exchange.messages == 1);
  CHECK(less.exchange.bytes == 10);
  CHECK(less.collective.messages == 3);
  CHECK(less.collective.bytes == 30);
  CHECK(again.halo.bytes == a.halo.bytes);
  CHECK(again.exchange.messages == a.exchange.messages);
  CHECK(again.collective.bytes == a.collective.bytes);
}

TEST_CASE("a halo within one rank sends nothing; a reduction is a call all the same") {
  const comm::Communicator self = comm::Communicator::self();
  const comm::Halo halo(self, 2, std::vector<comm::RemoteSlot>{{0, 1}, {0, 0}});
  const std::vector<double> roots{1, 2};
  std::vector<double> leaves(2);
  halo.forward(roots, leaves, 1);
  CHECK(leaves == std::vector<double>{2, 1});
  CHECK(sent_by(self).halo.messages == 0);
  CHECK(sent_by(self).halo.bytes == 0);
  CHECK(self.max(3.0) == 3.0);
  CHECK(sent_by(self).collective.messages == 1);
  CHECK(sent_by(self).collective.bytes == 8);
}
