// SPDX-License-Identifier: Apache-2.0
#include "comm/deal_out.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>
#include <vector>

using namespace brunt;
using comm::Communicator;

namespace {

/// Tasks of unequal length; each returns as many bytes as its number says.
std::vector<std::byte> task(GlobalIndex k) {
  if (k % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  return std::vector<std::byte>(static_cast<std::size_t>(k % 50), static_cast<std::byte>(k % 128));
}

}  // namespace

TEST_CASE("tasks are done once each, and their results come to the root in order", "[law]") {
  const Communicator ranks = Communicator::world();
  for (const GlobalIndex count : {0, 1, 3, 200}) {
    GlobalIndex here = 0, taken = 0;
    bool right = true;
    comm::deal_out(
        ranks, count,
        [&](GlobalIndex k) {
          ++here;
          return task(k);
        },
        [&](GlobalIndex k, std::span<const std::byte> bytes) {
          right = right && ranks.is_root() && k == taken && std::ranges::equal(bytes, task(k));
          ++taken;
        });
    CHECK(right);
    CHECK(ranks.sum(here) == count);
    CHECK(taken == (ranks.is_root() ? count : 0));
  }
}
