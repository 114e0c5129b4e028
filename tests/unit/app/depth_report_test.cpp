// SPDX-License-Identifier: Apache-2.0
// What is told of an answer, on the terminal and as JSON.
#include "app/depth/depth_report.hpp"

#include <catch2/catch.hpp>

#include "depth_rows.hpp"
#include "io/csv.hpp"

using namespace brunt;
using Catch::Contains;

TEST_CASE("depth_report: the screw takes the body from where it stood to where it is free") {
  const app::DepthRow row = support::depth_row();
  const app::PlacedScrew screw = app::placed_screw(row);
  const Vec3 corner(1, 2, 3);
  const Vec3 from = row.start(corner), wanted = row.answer.placement(corner);
  const Mat3 turn = depth::rotation_of(screw.degrees * 3.14159265358979324 / 180 * screw.axis).toRotationMatrix();
  const Vec3 found = screw.point + turn * (from - screw.point) + screw.slide * screw.axis;
  CHECK((found - wanted).norm() < 1e-13);
}

TEST_CASE("depth_report: a turn below the accuracy of the mode is a move") {
  app::DepthRow row = support::depth_row();
  row.answer.motion = {depth::Turn(depth::rotation_of(Vec3(0, 1e-6, 0))), Vec3(.3, 0, 0)};
  row.start.rotation.setIdentity();
  row.answer.placement = depth::moved(row.start, row.answer.motion, row.centroid);
  row.least_turn = 0;
  CHECK_THAT(app::described(row), Contains("  turn 5.72958e-05 degrees about the axis "));
  row.least_turn = 1e-5;
  CHECK_THAT(app::described(row), Contains("  move 0.3 along (1, 0, 0)\n"));
  const nlohmann::ordered_json json = app::as_json(row);
  CHECK(json["screw"]["degrees"] == 0);
  CHECK(json["screw"]["slide"] == .3);
  CHECK(json["placement"][0][2].get<double>() == Approx(1e-6));  // exact all the same
}

TEST_CASE("depth_report: an answer read from the table tells the same, but for the contacts") {
  const app::DepthRow row = support::depth_row();
  const auto record = io::csv_records(app::csv_row(row)).records.at(0);
  nlohmann::ordered_json one = app::as_json(row), other = app::as_json(app::row_of_record(record, "row"));
  CHECK(one["contacts"].size() == 2);
  CHECK(one["contact_count"] == 2);
  CHECK_FALSE(other.contains("contacts"));
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      CHECK(one["placement"][r][c].get<double>() ==
            Approx(other["placement"][r][c].get<double>()).margin(1e-14));  // by way of a quaternion
  for (nlohmann::ordered_json* json : {&one, &other}) {
    json->erase("contacts");
    json->erase("placement");
  }
  CHECK(one == other);
}

TEST_CASE("depth_report: text names what was found, and what was not") {
  app::DepthRow row = support::depth_row();
  CHECK_THAT(app::described(row),
             Contains("object_norm: depth 0.142857143, bound 0.1") && Contains("2 contact points"));
  row.answer.found = false;
  CHECK_THAT(app::described(row), Contains("no admissible motion separates them"));
  CHECK_FALSE(app::as_json(row).contains("placement"));
  row.answer = {};
  row.answer.distance = .25;
  CHECK(app::described(row) == "bar, 5\" long.stl and plate.obj do not overlap: distance 0.25\n");
}

TEST_CASE("depth_report: a depth above the overlaps together is warned of") {
  app::DepthRow row = support::depth_row();
  row.answer.overlaps = row.answer.depth;
  CHECK(app::warning_of(row, false).empty());
  row.answer.overlaps = .5 * row.answer.depth;
  CHECK_THAT(app::warning_of(row, false), Contains("warning: pose ") &&
                                              Contains("is more than the overlaps together, 0.0714") &&
                                              Contains("--careful"));
  CHECK_THAT(app::warning_of(row, true), !Contains("--careful") && Contains("with B moving"));
  row.answer.overlap = false;
  CHECK(app::warning_of(row, false).empty());
}
