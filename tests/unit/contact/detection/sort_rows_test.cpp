// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <tuple>

#include "contact/detection/detection.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

auto key_of_row(const Row& row) {
  return saved(row.key);
}

/// `runs` runs of ascending rows, each with its number as its gap.
std::vector<Row> rows_in_runs(int runs, int length, std::mt19937& random) {
  std::vector<Row> rows;
  for (int run = 0; run < runs; ++run) {
    std::vector<Row> some(static_cast<std::size_t>(length));
    for (Row& row : some) {
      const auto number = [&](std::uint64_t most) { return static_cast<GlobalIndex>(random() % most); };
      if (random() % 3 == 0)
        row.key = {RowKind::edge, number(50), number(5), number(1000), number(1000)};
      else if (run == 0)
        row.key = {.slave = number(50), .master = number(1000)};
      else
        row.key = {.kind = RowKind::wall, .slave = number(50), .master = run};
    }
    std::ranges::sort(some, {}, key_of_row);
    rows.insert(rows.end(), some.begin(), some.end());
  }
  for (std::size_t q = 0; q < rows.size(); ++q) rows[q].gap = static_cast<double>(q);
  return rows;
}

}  // namespace

TEST_CASE("rows are sorted by their keys, however many runs they come in, and nothing is lost") {
  std::mt19937 random(11);
  RowSortScratch scratch;  // the same for all, as from step to step
  for (const int runs : {0, 1, 2, 3, 4, 5, 8, 13, 60})
    for (const int length : {1, 2, 7, 40}) {
      std::vector<Row> rows = rows_in_runs(runs, length, random), expected = rows;
      std::ranges::stable_sort(expected, {}, key_of_row);
      sort_rows(rows, scratch);
      REQUIRE(rows.size() == expected.size());
      bool same = true;
      for (std::size_t q = 0; q < rows.size(); ++q)
        same = same && key_of_row(rows[q]) == key_of_row(expected[q]) && rows[q].gap == expected[q].gap;
      CHECK(same);
    }
}
