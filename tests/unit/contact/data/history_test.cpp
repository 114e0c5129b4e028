// SPDX-License-Identifier: Apache-2.0
// Records of contact by key: what a step finds again, what it leaves, and the way through tables.
#include "contact/data/history.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using contact::AnchorRecord;
using contact::History;
using contact::HistoryRecord;
using contact::Row;
using contact::row_key_from;

namespace {

Row row(GlobalIndex slave, GlobalIndex master, GlobalIndex second = no_index, GlobalIndex other = no_index) {
  return {.key = row_key_from({slave, second, master, other}), .normal = Vec3::UnitZ()};
}

HistoryRecord record(GlobalIndex slave, GlobalIndex face, double side) {
  return {row_key_from({slave, -1, face, -1}), {}, side};
}

HistoryRecord pushed(const contact::SavedKey& key, const std::array<double, 3>& force) {
  return {row_key_from(key), force};
}

contact::AnchorKey anchor_key(GlobalIndex slave, GlobalIndex master) {
  return contact::anchor_key_from({slave, master, -1, -1});
}

}  // namespace

TEST_CASE("impulses start from the forces of the same rows as their normals see them, the others from nothing") {
  std::vector<Row> rows{row(1, -2), row(1, 7), row(3, 7), row(3, 5, 4, 6), row(5, 1), row(6, -1)};
  rows[2].normal = Vec3(0, 0.6, 0.8);
  rows[5].cone = contact::Cone::free;
  const std::vector<HistoryRecord> records{pushed({1, -1, -2, -1}, {0, 0, 10}), pushed({1, -1, 8, -1}, {20, 0, 0}),
                                           pushed({3, -1, 7, -1}, {9, 0, 30}),  pushed({3, 4, 5, 6}, {0, 7, 40}),
                                           pushed({5, -1, 1, -1}, {0, 0, -50}), pushed({6, -1, -1, -1}, {0, 0, -60})};
  std::vector<Vec3> impulses(6, Vec3(99, 99, 99));
  start_impulses(rows, records, 0.5, impulses);
  const std::vector<double> along{5, 0, 12, 20, 0, -30};
  for (std::size_t q = 0; q < rows.size(); ++q)
    CHECK((impulses[q] - along[q] * rows[q].normal).norm() <
          1e-14);  // a row that only pushes does not start with a pull
}

TEST_CASE("a slave that has gone over to the next face takes along the force of the row that it has no more") {
  std::vector<Row> rows{row(1, -1), row(1, 4), row(1, 9), row(2, 4), row(3, 5, 6, 7), row(4, 2)};
  rows[1].normal = Vec3::UnitX();
  const std::vector<HistoryRecord> records{
      pushed({1, -1, -2, -1}, {0, 0, 10}),  // a wall has no next face
      pushed({1, -1, 7, -1}, {0.1, 0, 20}), pushed({2, -1, 4, -1}, {0, 0, 30}),
      pushed({2, -1, 5, -1}, {0, 0, 40}),                                          // no row is left without a record
      pushed({3, 6, 2, 5}, {0, 0, 50}),     pushed({4, -1, 3, -1}, {30, 0, 10})};  // the new face looks elsewhere
  std::vector<Vec3> impulses(rows.size(), Vec3(99, 99, 99));
  start_impulses(rows, records, 0.5, impulses);
  const std::vector<double> along{0, 0, 10, 15, 25, 0};
  for (std::size_t q = 0; q < rows.size(); ++q) {
    CAPTURE(q);
    CHECK((impulses[q] - along[q] * rows[q].normal).norm() < 1e-14);
  }
}

TEST_CASE("a step leaves what acted and the sides seen, in order of keys") {
  const std::vector<Row> rows{row(1, -2), row(1, 7), row(3, 5), row(3, 7)};
  const std::vector<HistoryRecord> sides{record(1, 7, -1), record(2, 7, 1), record(3, 5, 1), record(8, 1, -1)};
  std::vector<HistoryRecord> records(1);
  write_pairs(rows, std::vector<Vec3>{{0, 0, 2}, {0, 0, 0}, {0, 0, 4}, {0, 0, 0}}, 0.5, sides, records);
  REQUIRE(records.size() == 5);
  const auto is = [&](std::size_t i, GlobalIndex slave, GlobalIndex master, double force, double side) {
    const HistoryRecord& r = records[i];
    return r.key == row_key_from({slave, -1, master, -1}) && r.force == std::array<double, 3>{0, 0, force} &&
           r.side == side;
  };
  CHECK(is(0, 1, -2, 4, 0));
  CHECK(is(1, 1, 7, 0, -1));  // did not act, but its side is known
  CHECK(is(2, 2, 7, 0, 1));   // no row at all
  CHECK(is(3, 3, 5, 8, 1));
  CHECK(is(4, 8, 1, 0, -1));
}

TEST_CASE("anchors are found by slave and master, whichever face holds them") {
  Row on_face = row(3, 5);
  on_face.master_body = 2;
  const std::vector<AnchorRecord> anchors{
      {.key = anchor_key(1, 2)}, {.key = anchor_key(3, -1)}, {.key = anchor_key(3, 2), .face = 77}};
  const AnchorRecord* anchor = find_anchor(anchors, anchor_key_of(on_face));
  REQUIRE(anchor != nullptr);
  CHECK(anchor->face == 77);
  CHECK(find_anchor(anchors, anchor_key_of(row(3, -1))) == &anchors[1]);
  CHECK(find_anchor(anchors, anchor_key_of(row(3, -2))) == nullptr);
}

TEST_CASE("tables carry a history to the bit, in whatever order the records come") {
  History history;
  history.pairs = {{row_key_from({1, -1, -2, -1}), {0.1, 0, 0}, 0}, {row_key_from({3, 4, 5, 6}), {0, 0, -0.0}, -1}};
  history.anchors = {{anchor_key(3, 2), 77, {0.1, 0.2, 0.3, 0.4}, {1, 2, 3}},
                     {.key = anchor_key(4, -1)},
                     {.key = contact::anchor_key_from({5, 2, 8, 9})}};
  history.limits = {{anchor_key(1, 2), 0.7}, {anchor_key(3, -1), 0.1}};
  contact::HistoryTables tables;
  to_tables(history, tables);
  CHECK(tables[0].rows() == 2);
  CHECK(tables[1].values.size() == static_cast<std::size_t>(tables[1].rows() * tables[1].value_width));
  std::ranges::rotate(tables[0].keys, tables[0].keys.begin() + 4);
  std::ranges::rotate(tables[0].values, tables[0].values.begin() + 5);
  std::ranges::rotate(tables[2].keys, tables[2].keys.begin() + 4);
  std::ranges::rotate(tables[2].values, tables[2].values.begin() + 1);
  const History back = contact::from_tables(tables);
  REQUIRE(back.pairs.size() == 2);
  CHECK(back.pairs[0].key == history.pairs[0].key);
  CHECK(back.pairs[0].force[0] == 0.1);
  CHECK(std::signbit(back.pairs[1].force[2]));
  CHECK(back.pairs[1].side == -1);
  REQUIRE(back.anchors.size() == 3);
  const AnchorRecord& anchor = back.anchors[0];
  CHECK(anchor.key == anchor_key(3, 2));
  CHECK((anchor.face == 77 && anchor.weights[3] == 0.4 && anchor.on_wall[2] == 3));
  CHECK(back.anchors[1].key.kind == contact::RowKind::wall);
  CHECK(back.anchors[2].key.kind == contact::RowKind::edge);
  CHECK(tables[1].keys == std::vector<GlobalIndex>{3, 2, -1, -1, 77, 4, -1, -1, -1, -1, 5, 2, 8, 9, -1});
  REQUIRE(back.limits.size() == 2);
  CHECK((back.limits[0].key == anchor_key(1, 2) && back.limits[0].limit == 0.7));
  CHECK(back.limits[1].limit == 0.1);
}
