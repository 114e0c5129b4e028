// SPDX-License-Identifier: Apache-2.0
// Sorted arrays against counting by hand.
#include "core/sorted.hpp"

#include <catch2/catch.hpp>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

using brunt::equal_part;
using brunt::sort_unique;

namespace {

struct Entry {
  int key = 0, place = 0;
};

}  // namespace

TEST_CASE("sorted: each value once, in order") {
  std::mt19937 random(1);
  for (int size = 0; size < 30; ++size) {
    std::vector<int> values;
    for (int i = 0; i < size; ++i) values.push_back(static_cast<int>(random() % 9));
    const std::set<int> distinct(values.begin(), values.end());
    sort_unique(values);
    CHECK(values == std::vector<int>(distinct.begin(), distinct.end()));
  }
}

TEST_CASE("sorted: the part with one key") {
  std::vector<Entry> entries;
  for (const int key : {1, 1, 4, 4, 4, 7}) entries.push_back({key, static_cast<int>(entries.size())});
  for (int key = 0; key < 9; ++key) {
    std::vector<int> expected, found;
    for (const Entry& entry : entries)
      if (entry.key == key) expected.push_back(entry.place);
    for (const Entry& entry : equal_part(entries, key, &Entry::key)) found.push_back(entry.place);
    CHECK(found == expected);
  }
  CHECK(equal_part(std::vector<Entry>{}, 1, &Entry::key).empty());
}
