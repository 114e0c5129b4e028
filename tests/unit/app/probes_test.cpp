// SPDX-License-Identifier: Apache-2.0
// Columns and values of probes: motion of a set, force on a wall and between parts.
#include "app/report/probes.hpp"

#include <catch2/catch.hpp>

#include "prepared_scene.hpp"

using namespace brunt;

namespace {

const std::string watched =
    "contact: [{between: all}]\n"
    "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1]}]\n"
    "probes:\n"
    "  - {name: top, part: top, field: velocity}\n"
    "  - {name: push, contact: [top, low]}\n"
    "  - {name: wall, wall: w}\n";

}  // namespace

TEST_CASE("probes: three columns for a motion, with the impulse beside a force") {
  const support::PreparedScene scene(support::two_bodies + watched);
  const app::Probes probes(*scene.run, *scene::find_unit_system("SI"));
  REQUIRE(probes.columns().size() == 3 + 22 + 6);
  CHECK(probes.columns()[0].name == "top.x");
  CHECK(probes.columns()[0].unit == "m/s");
  CHECK(probes.columns()[3].name == "push.x");
  CHECK(probes.columns()[3].unit == "N");
  CHECK(probes.columns()[4].name == "impulse_push.x");
  CHECK(probes.columns()[4].unit == "N.s");
  CHECK(probes.columns()[9].name == "push.normal_x");
  CHECK(probes.columns()[20].name == "impulse_push.friction_z");
  CHECK(probes.columns()[21].name == "push.normal");
  CHECK(probes.columns()[24].name == "impulse_push.friction");
  CHECK(probes.columns()[30].name == "impulse_wall.z");
}

TEST_CASE("probes: motion at t_n, mean forces since the last row and impulses so far") {
  support::PreparedScene scene(support::two_bodies + watched);
  app::Probes probes(*scene.run, *scene::find_unit_system("SI"));
  contact::ContactTotals totals;
  totals.wall_impulse = {Vec3(0, 0, 3)};
  totals.tracked = {{.impulse = Vec3(-1, 0, 4), .friction = Vec3(-1, 0, 1), .normal_size = 3, .friction_size = 2}};
  probes.read_motion(*scene.run);
  scene.run->state.time = 0.5;
  const std::vector<double> first = probes.values(*scene.run, totals);
  REQUIRE(first.size() == 31);
  CHECK(first[0] == Approx(1));
  CHECK(first[2] == Approx(-2));
  CHECK(first[3] == -2);  // -1 in 0.5
  CHECK(first[4] == -1);
  CHECK(first[7] == 8);
  CHECK(first[13] == 6);  // along the normals 3 of 4
  CHECK(first[19] == 2);  // and 1 across them
  CHECK(first[21] == 6);  // sizes
  CHECK(first[24] == 2);
  CHECK(first[29] == 6);
  CHECK(first[30] == 3);
  totals.wall_impulse = {Vec3(0, 0, 4)};
  scene.run->state.time = 0.75;
  const std::vector<double> second = probes.values(*scene.run, totals);
  CHECK(second[7] == 0);
  CHECK(second[8] == 4);
  CHECK(second[21] == 0);
  CHECK(second[22] == 3);
  CHECK(second[29] == 4);  // 1 more in 0.25
  CHECK(second[30] == 4);
  CHECK(probes.values(*scene.run, totals)[29] == 0);  // no time has passed
}
