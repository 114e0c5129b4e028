// SPDX-License-Identifier: Apache-2.0
// Counted messages of exchanges whose number is known beforehand.
#include "comm/traffic.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "comm/halo.hpp"
#include "comm/rendezvous.hpp"

using namespace brunt;
using comm::Communicator;
using comm::Halo;
using comm::RemoteSlot;
using comm::Sent;
using comm::Traffic;

namespace {

void check(const Sent& sent, std::int64_t messages, std::int64_t bytes) {
  CHECK(sent.messages == messages);
  CHECK(sent.bytes == bytes);
}

}  // namespace

TEST_CASE("a halo counts a message for each other rank that wants something, and its values") {
  const Communicator ranks = Communicator::world();
  const int others = ranks.size() - 1;
  // every rank wants one root of each rank, and a second one of rank 0
  std::vector<RemoteSlot> source;
  for (Rank r = 0; r < ranks.size(); ++r) source.push_back({r, ranks.rank()});
  source.push_back({0, ranks.size() + ranks.rank()});
  const Halo halo(ranks, 2 * ranks.size(), source);
  constexpr int width = 3;
  std::vector<double> roots(2 * static_cast<std::size_t>(ranks.size()) * width, 1.0);
  std::vector<double> leaves(source.size() * width);

  const Traffic start = sent_by(ranks);
  halo.forward(roots, leaves, width);
  const Traffic forward = sent_by(ranks) - start;
  check(forward.halo, others, others * width * 8 * (ranks.is_root() ? 2 : 1));
  halo.backward(leaves, roots, width);
  const Traffic backward = sent_by(ranks) - start - forward;
  check(backward.halo, others, width * 8 * (others + (ranks.is_root() ? 0 : 1)));
  check(forward.exchange, 0, 0);
  check(forward.collective, 0, 0);
}

TEST_CASE("an exchange counts what goes to other ranks, and the call that tells the sizes") {
  const Communicator ranks = Communicator::world();
  std::vector<std::vector<double>> to_rank(static_cast<std::size_t>(ranks.size()));
  to_rank[static_cast<std::size_t>(ranks.rank())] = {1, 2, 3};  // stays here
  const Rank next = (ranks.rank() + 1) % ranks.size();
  to_rank[static_cast<std::size_t>(next)].push_back(4);
  const Traffic start = sent_by(ranks);
  comm::exchange(ranks, to_rank);
  const Traffic sent = sent_by(ranks) - start;
  check(sent.exchange, ranks.size() > 1 ? 1 : 0, ranks.size() > 1 ? 8 : 0);
  check(sent.collective, 1, 4 * ranks.size());
  check(sent.halo, 0, 0);
}

TEST_CASE("collectives count their calls and what this rank brings to them") {
  const Communicator ranks = Communicator::world();
  const Traffic start = sent_by(ranks);
  std::vector<double> values{1, 2};
  ranks.max(values);
  ranks.begin_max(values);
  ranks.end_max(values);
  CHECK(ranks.sum(GlobalIndex{1}) == ranks.size());
  ranks.barrier();
  check((sent_by(ranks) - start).collective, 4, 16 + 16 + 8);
  const Communicator copy = ranks;  // the same ranks, the same counters
  copy.barrier();
  check((sent_by(ranks) - start).collective, 5, 40);
  check(sent_by(Communicator::self()).collective, 0, 0);
}

TEST_CASE("pieces for the root count their length and their bytes") {
  const Communicator ranks = Communicator::world();
  const std::vector<std::byte> bytes(10);
  const Traffic start = sent_by(ranks);
  const auto gathered = ranks.gather(bytes);
  CHECK(gathered.size() == (ranks.is_root() ? static_cast<std::size_t>(ranks.size()) : 0U));
  const Traffic sent = sent_by(ranks) - start;
  check(sent.exchange, ranks.is_root() ? 0 : 2, ranks.is_root() ? 0 : 18);
}
