// SPDX-License-Identifier: Apache-2.0
#include "contact/births.hpp"

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

/// Rows of a step in which nodes move so far, all along their rows' normals.
void follow(std::span<const HistoryRecord> acted, double moved, bool surface_is_new, std::vector<Row>& rows,
            std::vector<BirthRecord>& births) {
  std::vector<NodeMotion> motion(2);
  motion[1].old_velocity = {0, 0, -moved};
  for (Row& row : rows) {
    row.node_count = 1;
    row.nodes[0] = 1;
    row.weights[0] = 1;
  }
  std::vector<BirthRecord> scratch;
  follow_births({acted, motion, 1.0, surface_is_new}, rows, births, scratch);
}

}  // namespace

TEST_CASE("a node behind a new face is born with its overlap; one that was pressed is not", "[law]") {
  std::vector<Row> rows{face_row(1, 10, 0, -0.3), face_row(1, 11, 0, -0.1), face_row(2, 10, 0, -0.2),
                        face_row(3, 10, 0, 0.4)};
  const std::vector<HistoryRecord> acted{{.key = {.slave = 2, .master = 10}, .force = {1, 0, 0}}};
  std::vector<BirthRecord> births;
  follow(acted, 1, true, rows, births);
  REQUIRE(births.size() == 2);
  CHECK(births[0].key.slave == 1);
  CHECK(births[0].key.master == 0);
  CHECK(births[0].penetration == 0.3);
  CHECK(births[1].penetration == 0);
  CHECK(births[1].depth == 0.2);
  CHECK(rows[0].gap == 0);
  CHECK(rows[0].required == 0);
  CHECK(rows[1].gap == Approx(0.2));  // of the same body: measured from the deepest
  CHECK(rows[2].gap == -0.2);
  CHECK(rows[2].required == 1);
  CHECK(rows[3].gap == 0.4);
}

TEST_CASE("a birth goes with the node as it comes out, and never comes back", "[law]") {
  std::vector<BirthRecord> births{{{.slave = 1, .master = 0}, 0.3, 0.3}, {{.slave = 2, .master = 0}, 0.2, 0.2}};
  std::vector<Row> rows{face_row(1, 10, 0, 0.1), face_row(2, 10, 0, -0.05)};  // depths of 0.2 and 0.25 now
  follow({}, 0.05, false, rows, births);
  REQUIRE(births.size() == 2);
  CHECK(births[0].penetration == Approx(0.2));
  CHECK(births[1].penetration == Approx(0.2));
  CHECK(rows[1].gap == -0.05);       // it came in by its motion
  rows = {face_row(2, 10, 0, 0.3)};  // the first meets nothing, the second is outside
  follow({}, 0.5, false, rows, births);
  CHECK(births.empty());
}

TEST_CASE("a row that is deep when it first appears, with no face new, is born with what motion does not explain",
          "[law]") {
  std::vector<BirthRecord> births{{{.slave = 2, .master = 0}, 0.1, 0.15}};
  // a node that met nothing; one that was 0.05 deeper than its birth; both move by 0.02
  std::vector<Row> rows{face_row(1, 10, 0, -0.3), face_row(2, 11, 0, -0.2)};
  follow({}, 0.02, false, rows, births);
  REQUIRE(births.size() == 2);
  CHECK(births[0].penetration == Approx(0.28));
  CHECK(births[1].penetration == Approx(0.1 + 0.13));
  CHECK(rows[0].gap == Approx(-0.02));
  CHECK(rows[0].required == 0);
  CHECK(rows[1].gap == Approx(-0.07));
  rows = {face_row(1, 10, 0, -0.01), face_row(2, 12, 0, -0.06)};  // another face of the same body, no deeper
  follow({}, 0.02, false, rows, births);
  CHECK(births[0].penetration == Approx(0.28));
  CHECK(births[1].penetration == Approx(0.23));
}
