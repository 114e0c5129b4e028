// SPDX-License-Identifier: Apache-2.0
// Copies between ranks: rank r has 2 + r roots, their values tell where they come from.
#include "comm/halo.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace brunt;
using comm::Communicator;
using comm::Halo;
using comm::RemoteSlot;

namespace {

double value(Rank rank, LocalIndex root, int component) {
  return 100.0 * rank + 10.0 * root + component;
}

std::vector<double> root_values(Rank rank, LocalIndex roots, int width) {
  std::vector<double> values;
  for (LocalIndex i = 0; i < roots; ++i)
    for (int c = 0; c < width; ++c) values.push_back(value(rank, i, c));
  return values;
}

}  // namespace

TEST_CASE("leaves take the values of roots on every rank, this one included") {
  const Communicator ranks = Communicator::world();
  std::vector<RemoteSlot> source;
  for (Rank r = ranks.size() - 1; r >= 0; --r) {
    source.push_back({r, 1 + r});
    source.push_back({r, 0});
  }
  if (ranks.size() > 1 && ranks.rank() == ranks.size() - 1) source.clear();  // a rank that wants nothing
  const Halo halo(ranks, 2 + ranks.rank(), source);
  for (const int width : {3, 1, 6, 3}) {
    const std::vector<double> roots = root_values(ranks.rank(), halo.roots(), width);
    std::vector<double> leaves(source.size() * static_cast<std::size_t>(width), -1.0);
    halo.forward(roots, leaves, width);
    for (std::size_t i = 0; i < source.size(); ++i)
      for (int c = 0; c < width; ++c)
        CHECK(leaves[i * static_cast<std::size_t>(width) + static_cast<std::size_t>(c)] ==
              value(source[i].rank, source[i].index, c));
  }
}

TEST_CASE("two exchanges may be under way at once") {
  const Communicator ranks = Communicator::world();
  const Rank next = (ranks.rank() + 1) % ranks.size();
  const Halo halo(ranks, 1, std::vector<RemoteSlot>{{next, 0}});
  const std::vector<double> first{1.0 + ranks.rank()}, second{-1.0 - ranks.rank()};
  std::vector<double> first_leaf(1), second_leaf(1);
  halo.begin(first, first_leaf, 1);
  halo.begin(second, second_leaf, 1);
  halo.end(first, first_leaf, 1);
  halo.end(second, second_leaf, 1);
  CHECK(first_leaf[0] == 1.0 + next);
  CHECK(second_leaf[0] == -1.0 - next);
}

TEST_CASE("backward brings each leaf home and leaves other roots alone") {
  const Communicator ranks = Communicator::world();
  const Rank next = (ranks.rank() + 1) % ranks.size();
  const Halo halo(ranks, 3, std::vector<RemoteSlot>{{next, 2}, {next, 0}});
  const std::vector<double> leaves{value(ranks.rank(), 0, 0), value(ranks.rank(), 0, 1), value(ranks.rank(), 1, 0),
                                   value(ranks.rank(), 1, 1)};
  std::vector<double> roots(6, -7.0);
  halo.backward(leaves, roots, 2);
  const Rank from = (ranks.rank() + ranks.size() - 1) % ranks.size();
  CHECK(roots ==
        std::vector<double>{value(from, 1, 0), value(from, 1, 1), -7.0, -7.0, value(from, 0, 0), value(from, 0, 1)});
}

TEST_CASE("all roots on one rank, leaves on the others") {
  const Communicator ranks = Communicator::world();
  const LocalIndex roots = ranks.is_root() ? 1 : 0;
  const std::vector<RemoteSlot> source(ranks.is_root() ? 0 : 1, RemoteSlot{0, 0});
  const Halo halo(ranks, roots, source);
  const std::vector<double> root(static_cast<std::size_t>(roots), 4.5);
  std::vector<double> leaf(source.size(), 0.0);
  halo.forward(root, leaf, 1);
  for (const double x : leaf) CHECK(x == 4.5);
  CHECK(halo.leaves() == (ranks.is_root() ? 0 : 1));
}
