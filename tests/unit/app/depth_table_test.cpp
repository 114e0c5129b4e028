// SPDX-License-Identifier: Apache-2.0
// Rows of depth.csv: what is written is read back, and rows of others are refused.
#include "app/depth/depth_table.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "depth_rows.hpp"
#include "io/csv.hpp"

using namespace brunt;
using Catch::Contains;

TEST_CASE("depth_table: a row has a field a column and reads back to the same numbers") {
  const app::DepthRow row = support::depth_row();
  const auto records = io::csv_records(app::csv_header() + app::csv_row(row)).records;
  REQUIRE(records.size() == 2);
  CHECK(records[0].size() == records[1].size());
  CHECK(records[0].back() == "proven");
  const app::EarlierRow read = app::row_of_record(records[1], "depth.csv: row 1");
  const depth::Answer &one = row.answer, &other = read.row.answer;
  CHECK(read.row.pose == row.pose);
  CHECK(read.row.a == row.a);
  CHECK(read.row.b == row.b);
  CHECK(read.row.metric == row.metric);
  CHECK(read.row.seconds == Approx(row.seconds));
  CHECK(other.overlap == one.overlap);
  CHECK(other.found == one.found);
  CHECK(other.depth == one.depth);
  CHECK(other.bound == one.bound);
  CHECK(other.overlaps == one.overlaps);
  CHECK(other.placement.translation == one.placement.translation);
  CHECK((other.placement.rotation - one.placement.rotation).norm() < 1e-14);  // by way of a quaternion
  CHECK(other.walks == one.walks);
  CHECK(other.steps == one.steps);
  CHECK(other.queries == one.queries);
  const app::PlacedScrew screw = app::placed_screw(row);
  CHECK(read.screw.axis == screw.axis);
  CHECK(read.screw.point == screw.point);
  CHECK(read.screw.degrees == screw.degrees);
  CHECK(read.screw.slide == screw.slide);
  CHECK(read.contacts == 2);
}

TEST_CASE("depth_table: what is no row is refused by name") {
  const auto record = io::csv_records(app::csv_row(support::depth_row())).records.at(0);
  auto cut = record, word = record;
  cut.pop_back();
  word[6] = "deep";
  CHECK_THROWS_WITH(app::row_of_record(cut, "depth.csv: row 4"),
                    Contains("depth.csv: row 4: invalid row of 30 fields; expected 31"));
  CHECK_THROWS_WITH(app::row_of_record(word, "depth.csv: row 4"), Contains("'deep'"));
  CHECK_THROWS_AS(app::row_of_record({}, "x"), InputError);
}
