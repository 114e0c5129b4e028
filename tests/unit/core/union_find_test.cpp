// SPDX-License-Identifier: Apache-2.0
#include "core/union_find.hpp"

#include <catch2/catch.hpp>

using brunt::UnionFind;

TEST_CASE("Joined members have the least of them as their first, in any order of joins") {
  for (const bool forwards : {true, false}) {
    UnionFind joined(100);
    for (std::size_t k = 0; k < 48; ++k) {
      const std::size_t from = forwards ? k : 47 - k;
      joined.join(2 * from + 2, 2 * from);  // even members up to 96
    }
    joined.join(99, 97);
    for (std::size_t member = 0; member < 97; member += 2) CHECK(joined.first(member) == 0);
    for (std::size_t member = 1; member < 97; member += 2) CHECK(joined.first(member) == member);
    CHECK(joined.first(98) == 98);
    CHECK(joined.first(99) == 97);
    joined.join(99, 50);
    CHECK(joined.first(97) == 0);
    joined.reset(3);
    CHECK(joined.size() == 3);
    CHECK(joined.first(2) == 2);
  }
}
