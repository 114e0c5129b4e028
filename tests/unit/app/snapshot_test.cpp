// SPDX-License-Identifier: Apache-2.0
// A snapshot gives back the saved arrays, strided ones too, and leaves the others alone.
#include "app/report/snapshot.hpp"

#include <catch2/catch.hpp>
#include <numeric>

using namespace brunt;

TEST_CASE("snapshot: gives back what a checkpoint would hold") {
  std::vector<double> rows(6), batches(32), scratch(2);
  std::iota(rows.begin(), rows.end(), 1.0);
  std::iota(batches.begin(), batches.end(), 100.0);
  model::Registry registry;
  registry.arrays.push_back({"rows", model::StateArray::Entity::node, -1, 2, 3, rows.data(), 1, 3, 1, 0, true, true});
  // ten elements with two components in batches of eight lanes: the last six lanes are padding
  registry.arrays.push_back(
      {"batches", model::StateArray::Entity::element, 0, 10, 2, batches.data(), 8, 16, 8, 1, true, true});
  registry.arrays.push_back(
      {"scratch", model::StateArray::Entity::global, -1, 1, 2, scratch.data(), 1, 1, 1, 0, false, false});
  const std::vector<double> rows_then = rows, batches_then = batches;

  app::Snapshot snapshot;
  CHECK(snapshot.empty());
  snapshot.take(registry);
  CHECK_FALSE(snapshot.empty());
  for (auto* values : {&rows, &batches, &scratch}) std::fill(values->begin(), values->end(), -1.0);
  snapshot.give_back(registry);
  CHECK(rows == rows_then);
  CHECK(scratch == std::vector<double>{-1, -1});
  for (LocalIndex e = 0; e < 10; ++e)
    for (int c = 0; c < 2; ++c) {
      const auto k = static_cast<std::size_t>(e / 8 * 16 + c * 8 + e % 8);
      CHECK(batches[k] == batches_then[k]);
    }
  CHECK(batches[16 + 7] == -1);  // padding is nobody's state

  rows[0] = 7;
  snapshot.take(registry);
  rows[0] = 0;
  snapshot.give_back(registry);
  CHECK(rows[0] == 7);
}

TEST_CASE("snapshot: records that have come and gone since are as they were") {
  RecordTable pairs{.name = "pairs", .key_width = 2, .value_width = 1, .keys = {1, 2, 3, 4}, .values = {0.5, 0.25}};
  model::Registry registry;
  registry.tables.push_back(&pairs);
  app::Snapshot snapshot;
  snapshot.take(registry);
  pairs.keys = {9, 9};
  pairs.values = {1};
  snapshot.give_back(registry);
  CHECK(pairs.keys == std::vector<GlobalIndex>{1, 2, 3, 4});
  CHECK(pairs.values == std::vector<double>{0.5, 0.25});
}
