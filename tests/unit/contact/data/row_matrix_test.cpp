// SPDX-License-Identifier: Apache-2.0
// Rows of any length in compressed storage, and keys as they are saved.
#include "contact/data/row_matrix.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::contact;

namespace {

/// Row 0: twelve points, weights of both signs; row 1: one point; row 2: two points with arms.
RowMatrix three_rows() {
  RowMatrix rows;
  for (LocalIndex point = 0; point < 12; ++point) rows.add(point, point % 2 == 0 ? 0.25 : -0.25);
  rows.close_row({.normal = Vec3::UnitZ(), .required = 1}, {.gap = -0.1});
  rows.add(3, 1);
  rows.close_row({.normal = Vec3::UnitX(), .required = 2}, {.pass = Pass::second});
  rows.add(5, 1, Arm{});
  rows.add(6, -1, Arm{.turn = 2 * Mat3::Identity(), .size = 2});
  rows.close_row({.normal = Vec3::UnitY(), .across = Across::holds, .turns = true}, {});
  return rows;
}

Vec3 velocity_of(LocalIndex point) {
  return {1.0 * point, 1, -2.0 * point};
}

}  // namespace

TEST_CASE("rows of any length: their rates, and what their points take") {
  const RowMatrix rows = three_rows();
  REQUIRE(rows.size() == 3);
  CHECK(rows.entries() == 15);
  CHECK(relative_velocity(rows, 0, velocity_of) ==
        Vec3(-1.5, 0, 3));  // six times a quarter of the step from one to next
  CHECK(relative_velocity(rows, 1, velocity_of) == Vec3(3, 1, -6));
  CHECK(relative_velocity(rows, 2, velocity_of) == Vec3(5, 1, -10) + Vec3(6, 1, -12));
  CHECK(rows.leader(2) == 5);
  CHECK(impulse_on_point(rows, 0, 11, {0, 0, 4}) == Vec3(0, 0, -1));
  CHECK(impulse_on_point(rows, 2, rows.begin(2) + 1, {1, 0, 4}) == Vec3(1, 0, 4));  // 2 - 1
}

TEST_CASE("rows go over to another matrix one by one, and a matrix is filled anew") {
  const RowMatrix all = three_rows();
  RowMatrix some;
  some.append(all, 2);
  some.append(all, 0);
  REQUIRE(some.size() == 2);
  CHECK(relative_velocity(some, 0, velocity_of) == relative_velocity(all, 2, velocity_of));
  CHECK(relative_velocity(some, 1, velocity_of) == relative_velocity(all, 0, velocity_of));
  CHECK(some.figures[1].gap == -0.1);
  some.clear();
  CHECK(some.size() == 0);
  some.append(all, 1);
  CHECK(some.laws[0].required == 2);
  CHECK(some.figures[0].pass == Pass::second);
}

TEST_CASE("rows of detection in the matrix: laws without sentinels") {
  std::vector<Row> rows(3);
  rows[0].friction = 0.3;
  rows[1].holds = true;
  rows[1].cone = Cone::free;
  for (Row& row : rows) {
    row.nodes = {7, 8};
    row.weights = {1, -1};
    row.node_count = 2;
  }
  RowMatrix matrix;
  compress(rows, matrix);
  REQUIRE(matrix.size() == 3);
  CHECK((matrix.laws[0].across == Across::rubs && matrix.laws[0].friction == 0.3));
  CHECK((matrix.laws[1].across == Across::holds && matrix.laws[1].friction == 0));
  CHECK(matrix.laws[2].across == Across::slips);
  CHECK(matrix.points == std::vector<LocalIndex>{7, 8, 7, 8, 7, 8});
}

TEST_CASE("keys come back from what is saved, in its order") {
  const std::vector<RowKey> keys{{.kind = RowKind::mortar_tie, .slave = 3, .master = 1, .master_second = 0},
                                 {.kind = RowKind::mortar, .slave = 3, .master = 1, .master_second = 1},
                                 {.kind = RowKind::wall, .slave = 3, .master = 1},
                                 {.kind = RowKind::wall, .slave = 3, .master = 0},
                                 {.slave = 3, .master = 0},
                                 {.slave = 3, .master = 9},
                                 {RowKind::edge, 3, 4, 1, 2}};
  CHECK(std::ranges::is_sorted(keys));
  for (const RowKey& key : keys) {
    const RowKey back = row_key_from(saved(key));
    CHECK(back.kind == key.kind);
    CHECK(back == key);
  }
  CHECK(saved(keys[0]) == SavedKey{3, -3, 1, 0});
  CHECK(saved(keys[2]) == SavedKey{3, -1, -2, -1});
  CHECK(saved(RowKey{.kind = RowKind::tie, .slave = 3, .master = 9}) == saved(keys[5]));
}
