// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/births.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::contact;

namespace {

Row face_row(GlobalIndex slave, GlobalIndex face, std::int32_t body, double gap) {
  Row row;
  row.key = {.slave = slave, .master = face};
  row.master_body = body;
  row.gap = gap;
  row.required = 1;
  return row;
}

}  // namespace

TEST_CASE("a node behind a new face is born with its overlap; one that was pressed is not", "[law]") {
  std::vector<Row> rows{face_row(1, 10, 0, -0.3), face_row(1, 11, 0, -0.1), face_row(2, 10, 0, -0.2),
                        face_row(3, 10, 0, 0.4)};
  const std::vector<HistoryRecord> acted{{.key = {.slave = 2, .master = 10}, .force = {1, 0, 0}}};
  std::vector<BirthRecord> births;
  begin_births(acted, rows, births);
  REQUIRE(births.size() == 1);
  CHECK(births[0].key.slave == 1);
  CHECK(births[0].key.master == 0);
  CHECK(births[0].penetration == 0.3);
  CHECK(rows[0].gap == 0);
  CHECK(rows[0].required == 0);
  CHECK(rows[1].gap == Approx(0.2));  // of the same body: measured from the deepest
  CHECK(rows[2].gap == -0.2);
  CHECK(rows[2].required == 1);
  CHECK(rows[3].gap == 0.4);
}

TEST_CASE("a birth goes with the node as it comes out, and never comes back", "[law]") {
  std::vector<BirthRecord> births{{{.slave = 1, .master = 0}, 0.3}, {{.slave = 2, .master = 0}, 0.2}};
  std::vector<Row> rows{face_row(1, 10, 0, 0.1), face_row(2, 10, 0, -0.05)};  // depths of 0.2 and 0.25 now
  fade_births(rows, births);
  REQUIRE(births.size() == 2);
  CHECK(births[0].penetration == Approx(0.2));
  CHECK(births[1].penetration == Approx(0.2));
  rows = {face_row(2, 10, 0, 0.3)};  // the first meets nothing, the second is outside
  fade_births(rows, births);
  CHECK(births.empty());
}
