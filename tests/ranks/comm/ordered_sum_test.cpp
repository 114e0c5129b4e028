// SPDX-License-Identifier: Apache-2.0
// Nodal sums of a 4 x 3 patch of quadrilaterals, split in several ways: every copy of a node holds the bits of the
// sum in element order, and a step allocates nothing.
#include "comm/ordered_sum.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "tests/support/allocations.hpp"

using namespace brunt;
using comm::Communicator;
using comm::Contribution;
using comm::OrderedSum;

namespace {

constexpr int columns = 4, rows = 3;
constexpr int elements = columns * rows;

GlobalIndex corner_node(int element, int corner) {
  const int i = element % columns + (corner == 1 || corner == 2 ? 1 : 0);
  const int j = element / columns + (corner >= 2 ? 1 : 0);
  return j * (columns + 1) + i;
}

/// Corner forces of very different size, so that the order of summation shows in the bits. From a table: computed
/// where they are added, the compiler would fuse product and sum and round differently.
double corner_force(int element, int corner, int component) {
  static const std::vector<double> table = [] {
    std::vector<double> values;
    for (int k = 0; k < elements * 4 * 3; ++k) values.push_back(std::sin(1.0 + k) * std::pow(10.0, k % 17 - 8));
    return values;
  }();
  return table[static_cast<std::size_t>((element * 4 + corner) * 3 + component)];
}

double sum_in_element_order(GlobalIndex node, int component) {
  double sum = 0.0;
  for (int e = 0; e < elements; ++e)
    for (int c = 0; c < 4; ++c)
      if (corner_node(e, c) == node) sum += corner_force(e, c, component);
  return sum;
}

/// The piece of one rank: its corners as slots, its nodes, those shared and with whom.
struct Piece {
  std::vector<int> element;
  std::vector<GlobalIndex> node_gid;
  std::vector<Contribution> contributions;
  std::vector<LocalIndex> shared;
  std::vector<GlobalIndex> shared_gid;
  Ragged<Rank> sharers;
};

Piece piece_of(Rank rank, const std::function<Rank(int)>& rank_of) {
  std::map<GlobalIndex, std::set<Rank>> holders;
  for (int e = 0; e < elements; ++e)
    for (int c = 0; c < 4; ++c) holders[corner_node(e, c)].insert(rank_of(e));
  Piece piece;
  std::map<GlobalIndex, LocalIndex> local;
  for (const auto& [gid, held_by] : holders) {
    if (!held_by.contains(rank)) continue;
    const auto node = static_cast<LocalIndex>(piece.node_gid.size());
    local[gid] = node;
    piece.node_gid.push_back(gid);
    if (held_by.size() == 1) continue;
    piece.shared.push_back(node);
    piece.shared_gid.push_back(gid);
    for (const Rank other : held_by)
      if (other != rank) piece.sharers.values.push_back(other);
    piece.sharers.close_row();
  }
  for (int e = 0; e < elements; ++e) {
    if (rank_of(e) != rank) continue;
    piece.element.push_back(e);
    for (int c = 0; c < 4; ++c)
      piece.contributions.push_back({GlobalIndex{e} * 8 + c, corner_node(e, c), local[corner_node(e, c)]});
  }
  return piece;
}

std::vector<double> slots_of(const Piece& piece, int width) {
  std::vector<double> slots;
  for (const int e : piece.element)
    for (int c = 0; c < 4; ++c)
      for (int k = 0; k < width; ++k) slots.push_back(corner_force(e, c, k));
  return slots;
}

void check_sums(const Communicator& ranks, const std::function<Rank(int)>& rank_of) {
  const Piece piece = piece_of(ranks.rank(), rank_of);
  OrderedSum sum(ranks, piece.contributions, piece.shared, piece.shared_gid, piece.sharers);
  REQUIRE(sum.shared_nodes().size() == piece.shared.size());
  constexpr int stride = 4;
  for (const int width : {1, 3}) {
    const std::vector<double> slots = slots_of(piece, width);
    std::vector<double> nodes(piece.node_gid.size() * stride, -1.0);
    sum.begin(slots, width);
    sum.end(slots, width, nodes, stride);
    for (const LocalIndex shared : piece.shared) {
      const auto node = static_cast<std::size_t>(shared);
      for (int k = 0; k < width; ++k)
        CHECK(nodes[node * stride + static_cast<std::size_t>(k)] == sum_in_element_order(piece.node_gid[node], k));
      CHECK(nodes[node * stride + 3] == -1.0);
    }
  }
}

}  // namespace

TEST_CASE("shared nodes get the sum in element order, bit for bit") {
  const Communicator ranks = Communicator::world();
  const int n = ranks.size();
  SECTION("rows of elements") {
    check_sums(ranks, [n](int e) { return e * n / elements; });
  }
  SECTION("elements dealt out one by one") {
    check_sums(ranks, [n](int e) { return e % n; });
  }
  SECTION("backwards, the last rank with nothing") {
    check_sums(ranks, [n](int e) { return n == 1 ? 0 : (elements - 1 - e) % (n - 1); });
  }
}

TEST_CASE("an ordered sum allocates nothing after its first use") {
  const Communicator ranks = Communicator::world();
  const Piece piece = piece_of(ranks.rank(), [&](int e) { return e % ranks.size(); });
  OrderedSum sum(ranks, piece.contributions, piece.shared, piece.shared_gid, piece.sharers);
  const std::vector<double> slots = slots_of(piece, 3);
  std::vector<double> nodes(piece.node_gid.size() * 3);
  const auto step = [&] {
    sum.begin(slots, 3);
    sum.end(slots, 3, nodes, 3);
  };
  step();
  const long before = test::allocations;
  for (int i = 0; i < 10; ++i) step();
  const long after = test::allocations;
  CHECK(after == before);
}

TEST_CASE("two contributions to a node may not have one key") {
  const std::vector<Contribution> twins{{5, 0, 0}, {5, 0, 0}};
  const std::vector<LocalIndex> node{0};
  const std::vector<GlobalIndex> gid{0};
  Ragged<Rank> sharers;
  sharers.close_row();
  CHECK_THROWS(OrderedSum(Communicator::self(), twins, node, gid, sharers));
}
