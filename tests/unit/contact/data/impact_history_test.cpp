// SPDX-License-Identifier: Apache-2.0
#include "contact/data/impact_history.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "contact/data/history.hpp"

using namespace brunt;
using contact::ImpactRecord;
using contact::ImpactState;
using contact::Row;

namespace {

Row row(GlobalIndex slave, GlobalIndex face, std::int32_t body) {
  return {.key = contact::row_key_from({slave, -1, face, -1}), .master_body = body, .normal = Vec3::UnitZ()};
}

bool same(const ImpactState& one, const ImpactState& other) {
  return one.bank == other.bank && one.pressed == other.pressed && one.recent == other.recent &&
         one.most == other.most && one.flow == other.flow;
}

}  // namespace

TEST_CASE("the state of a row follows its slave to the next face, and rows with one key share the bank") {
  const std::vector<Row> before{row(1, 4, 2), row(2, -1, 0), row(3, 8, 2), row(3, 9, 2), row(5, 1, 0)};
  const std::vector<ImpactState> states{{1, 2, 3, 4, 0}, {5, 6, 7, 8, 0.5}, {2, 3, 1, 9, 0}, {4, 1, 5, 2, 0.1}, {}};
  std::vector<ImpactRecord> records;
  write_impacts(before, states, records);
  REQUIRE(records.size() == 3);  // one of two rows, none of a row that is open
  const std::vector<Row> after{row(1, 5, 2), row(2, -1, 0), row(3, 8, 2), row(3, 9, 2), row(4, 8, 2)};
  std::vector<ImpactState> found(after.size());
  read_impacts(after, records, found);
  CHECK(same(found[0], states[0]));
  CHECK(same(found[1], states[1]));
  CHECK(same(found[2], {3, 3, 5, 9, 0.1}));
  CHECK(same(found[3], {3, 3, 5, 9, 0.1}));
  CHECK(found[4].flow == -1);
}

TEST_CASE("records go through a table, in whatever order they come back") {
  const std::vector<Row> rows{row(1, 4, 2), row(2, -3, 0), row(7, 4, 1)};
  const std::vector<ImpactState> states{{0.1, 2, 3, 4, 0}, {-0.0, 6, 7, 8, 0.5}, {1e-300, 1, 1, 1, 0}};
  std::vector<ImpactRecord> records;
  write_impacts(rows, states, records);
  RecordTable table = contact::impact_table(records);
  CHECK(table.rows() == 3);
  std::ranges::rotate(table.keys, table.keys.begin() + 4);
  std::ranges::rotate(table.values, table.values.begin() + 5);
  const std::vector<ImpactRecord> back = contact::impacts_from(table);
  REQUIRE(back.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(back[i].key == records[i].key);
    CHECK(same(back[i].state, records[i].state));
  }
  CHECK(contact::impacts_from({}).empty());
}
