// SPDX-License-Identifier: Apache-2.0
// Contact nodes around a ring of ranks: each rank owns two, and copies the second of the next rank.
#include "contact/lists/halo_exchange.hpp"

#include <catch2/catch.hpp>

using namespace brunt;

namespace {

/// Nodes here: 0 and 1 of this rank, 2 a copy of the next rank's 1 (its own on one rank, where nothing is linked).
struct Ring {
  comm::Communicator ranks = comm::Communicator::world();
  Rank here = ranks.rank(), next = (here + 1) % ranks.size(), before = (here + ranks.size() - 1) % ranks.size();
  bool linked = ranks.size() > 1;
  contact::HaloExchange exchange{ranks, 3, links(), 5};

  [[nodiscard]] contact::NodeLinks links() const {
    if (!linked) return {};
    return {.copies = {2}, .source = {{next, 1}}, .copied = {1}, .destination = {{before, 2}}};
  }
};

double tag(Rank rank, int node, int component) {
  return 100.0 * rank + 10.0 * node + component;
}

}  // namespace

TEST_CASE("copies take their owner's values, of any width up to the widest") {
  Ring ring;
  for (const int width : {1, 3, 5}) {
    std::vector<double> values;
    for (int node = 0; node < 3; ++node)
      for (int c = 0; c < width; ++c) values.push_back(tag(ring.here, node, c));
    std::vector<double> expected = values;
    if (ring.linked)
      for (int c = 0; c < width; ++c) expected[static_cast<std::size_t>(2 * width + c)] = tag(ring.next, 1, c);
    ring.exchange.share(values, width);
    CHECK(values == expected);
  }
}

TEST_CASE("owners add what their copies hold, and copies keep it") {
  Ring ring;
  constexpr int width = 2;
  std::vector<double> values;
  for (int node = 0; node < 3; ++node)
    for (int c = 0; c < width; ++c) values.push_back(tag(ring.here, node, c));
  std::vector<double> expected = values;
  if (ring.linked)
    for (std::size_t c = 0; c < width; ++c) expected[width + c] += tag(ring.before, 2, static_cast<int>(c));
  ring.exchange.sum_to_owner(values, width);
  CHECK(values == expected);
}

TEST_CASE("two arrays at once: the same as one after the other") {
  Ring ring;
  std::vector<double> narrow, wide;
  for (int node = 0; node < 3; ++node) {
    narrow.push_back(tag(ring.here, node, 9));
    for (int c = 0; c < 4; ++c) wide.push_back(tag(ring.here, node, c));
  }
  std::vector<double> narrow_alone = narrow, wide_alone = wide;
  ring.exchange.sum_to_owner(narrow_alone, 1);
  ring.exchange.sum_to_owner(wide_alone, 4);
  ring.exchange.sum_both_to_owner({narrow, 1}, {wide, 4});
  CHECK(narrow == narrow_alone);
  CHECK(wide == wide_alone);
  ring.exchange.share(narrow_alone, 1);
  ring.exchange.share(wide_alone, 4);
  ring.exchange.share_both({narrow, 1}, {wide, 4});
  CHECK(narrow == narrow_alone);
  CHECK(wide == wide_alone);
}

TEST_CASE("the largest over all ranks, element by element, and sums in the same message") {
  Ring ring;
  const auto last = static_cast<double>(ring.ranks.size() - 1);
  std::vector<double> values{static_cast<double>(ring.here), -static_cast<double>(ring.here), 7};
  ring.exchange.max(values);
  CHECK(values == std::vector<double>{last, 0, 7});
  std::vector<double> largest{1.5 * ring.here};
  std::vector<std::int64_t> sums{1, ring.here, std::int64_t{1} << 61};
  if (ring.here > 0) sums[2] = -1;
  ring.exchange.reduce(largest, sums);
  const std::int64_t n = ring.ranks.size();
  CHECK(largest == std::vector<double>{1.5 * last});
  CHECK(sums == std::vector<std::int64_t>{n, n * (n - 1) / 2, (std::int64_t{1} << 61) - (n - 1)});
}
