// SPDX-License-Identifier: Apache-2.0
// Guards on made-up ledgers: what they warn of, what they stop, and what they leave alone.
#include "app/state/guards.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

using namespace brunt;
using namespace brunt::app;

namespace {

/// An impact of 100 units of energy, seen once.
struct Impact {
  Extremes seen;
  time::Ledger ledger;
  Impact() {
    ledger.kinetic = 100;
    ledger.mass = 2;
    observe(ledger, seen);
  }
  [[nodiscard]] std::vector<Finding> now(double rounding = 0) {
    observe(ledger, seen);
    return judge(ledger, seen, rounding);
  }
};

const scene::Guards limits;

using Term = double time::Ledger::*;
struct Column {
  Term term;
  Fault fault;
};
const std::vector<Column> columns{
    {&time::Ledger::hourglass, Fault::hourglass}, {&time::Ledger::bulk, Fault::bulk},
    {&time::Ledger::damping, Fault::damping},     {&time::Ledger::friction, Fault::friction},
    {&time::Ledger::internal, Fault::internal},   {&time::Ledger::contact, Fault::contact}};

}  // namespace

TEST_CASE("guards: a column that must not be negative warns below -1 % and stops below -10 % of the largest energy") {
  for (const Column& column : columns)
    for (const double share : {0.5, 0.005, -0.005, -0.0099, -0.011, -0.09, -0.11, -0.9}) {
      CAPTURE(static_cast<int>(column.fault), share);
      Impact impact;
      impact.ledger.*column.term = 100 * share;
      impact.ledger.kinetic -= 100 * share;  // the balance closes: what one column makes stands in another
      // the largest energy, kinetic + internal, grows with what another column made
      const double largest = column.fault == Fault::internal ? 100.0 : 100 + std::max(-100 * share, 0.0);
      const double of_largest = -100 * share / largest;
      const std::vector<Finding> found = impact.now();
      REQUIRE(found.size() == (of_largest > 0.01 ? 1 : 0));
      if (found.empty()) continue;
      CHECK(found[0].fault == column.fault);
      CHECK(found[0].energy == Approx(100 * share));
      CHECK(found[0].share == Approx(of_largest));
      CHECK(found[0].stop == (of_largest > 0.1));
      CHECK(text_of(found[0], 3).find("must not be negative") != std::string::npos);
      CHECK(likely_cause(found[0].fault).empty() == (found[0].fault == Fault::internal));
    }
}

TEST_CASE("guards: the change of the energy is a share of the largest one, and 0 while there was none") {
  Impact impact;
  impact.ledger.kinetic = 98;
  CHECK(energy_change(impact.ledger, impact.seen) == Approx(-0.02));
  Extremes seen;
  time::Ledger ledger;
  observe(ledger, seen);
  ledger.contact = -4e-27;
  REQUIRE(ledger.total() != seen.start_total);
  CHECK(energy_change(ledger, seen) == 0);
  CHECK(error_ratio(seen) == 0);
}

TEST_CASE("guards: contact may give where it parts bodies that began inside each other") {
  Impact impact;
  impact.ledger.contact = -50;
  impact.ledger.kinetic += 50;
  observe(impact.ledger, impact.seen);
  CHECK(judge(impact.ledger, impact.seen, 0).size() == 1);
  CHECK(judge(impact.ledger, impact.seen, 0, Gives::parting).empty());
}

TEST_CASE("guards: contact gives nothing back of what it has taken, but springs do") {
  Impact impact;
  impact.ledger.kinetic = 60;
  impact.ledger.contact = impact.ledger.contact_totals.contact_work = 40;
  CHECK(impact.now().empty());
  for (const double back : {0.5, 5.0, 20.0, 40.0, 60.0}) {  // the last: more than it took
    CAPTURE(back);
    impact.ledger.kinetic = 60 + back;
    impact.ledger.contact = impact.ledger.contact_totals.contact_work = 40 - back;
    const std::vector<Finding> found = impact.now();
    const double scale = std::max(100.0, 60 + back);
    const double returned = std::min(back, 40.0) / scale;
    const auto fault = std::ranges::find(found, Fault::returned, &Finding::fault);
    CHECK((fault != found.end()) == (returned > limits.energy_warning));
    if (fault != found.end()) {
      CHECK(fault->share == Approx(returned));
      CHECK(fault->stop == (returned > limits.energy_stop));
      CHECK(text_of(*fault, 3).find("given back") != std::string::npos);
    }
    CHECK(judge(impact.ledger, impact.seen, 0, Gives::stored).size() == (back > 40 ? 1 : 0));
    CHECK(judge(impact.ledger, impact.seen, 0, Gives::parting).empty());
  }
}

TEST_CASE("guards: friction is judged without the shear of ties, which give back what they took") {
  Impact impact;
  impact.ledger.friction = -30;
  impact.ledger.ties = -30;
  impact.ledger.internal = 30;
  CHECK(impact.now().empty());
  impact.ledger.ties = 30;  // the ties took, friction gave twice of it
  const std::vector<Finding> found = impact.now();
  REQUIRE(found.size() == 1);
  CHECK(found[0].energy == -60);
  CHECK(found[0].stop);
}

TEST_CASE("guards: the balance warns above 1 % and stops above 10 %, of either sign") {
  for (const double change : {0.5, -0.5, 2.0, -2.0, 9.9, -9.9, 12.0, -12.0}) {
    CAPTURE(change);
    Impact impact;
    impact.ledger.kinetic = 50;
    impact.ledger.internal = 50 + change;
    const std::vector<Finding> found = impact.now();
    const double share = std::abs(change) / std::max(100 + change, 100.0);
    REQUIRE(found.size() == (share > 0.01 ? 1 : 0));
    if (found.empty()) continue;
    CHECK(found[0].fault == Fault::balance);
    CHECK(found[0].stop == (share > 0.1));
  }
}

TEST_CASE("guards: shares are of the largest energy so far, not of what is left") {
  Impact impact;
  impact.ledger.kinetic = 1;  // flown off, the rest went into a wall
  impact.ledger.walls = 99;
  impact.ledger.hourglass = -0.9;
  impact.ledger.internal = 0.9;
  CHECK(impact.now().empty());
  impact.ledger.external = 1e4;  // a press has since worked
  impact.ledger.walls += 1e4;
  impact.ledger.hourglass = -90;
  impact.ledger.internal = 90;
  CHECK(impact.now().empty());
}

TEST_CASE("guards: what rounding makes of bodies at rest is below the floor, in any units") {
  for (const double unit : {1e-9, 1.0, 1e6}) {  // of length
    const double mass = 3, extent = 2 * unit, edge = 0.1 * unit, dt = 1e-5;
    const double floor = rounding_energy(mass, extent, edge, dt);
    CHECK(floor == Approx(mass * std::pow(1e-12 * edge / dt, 2)));
    CHECK(rounding_energy(mass, extent, 0, dt) == Approx(mass * std::pow(4 * 2.220446049250313e-16 * extent / dt, 2)));
    Extremes seen;
    time::Ledger rest;
    rest.mass = mass;
    observe(rest, seen);
    rest.kinetic = 0.05 * floor;
    rest.friction = -0.09 * floor;
    observe(rest, seen);
    CHECK(judge(rest, seen, floor).empty());
    CHECK(energy_growth(rest, seen, false, floor).empty());
    rest.friction = -30 * floor;
    CHECK(judge(rest, seen, floor).size() == 2);
  }
  CHECK(rounding_energy(1, 1, 1, 0) == 0);
  CHECK(settling_energy(6, 9.81, 1e-4, 1e-3, 0.05) == Approx(6 * 9.81 * 9.81 * 1e-8 * 0.02));  // 1e-7 of 6 kg at rest
  CHECK(judge({}, {}, 0).empty());
}

TEST_CASE("guards: energy from nowhere, and what is none") {
  Impact impact;
  CHECK(energy_growth(impact.ledger, impact.seen, false, 0).empty());
  impact.ledger.kinetic = 200;
  impact.ledger.contact = -100;
  CHECK_FALSE(energy_growth(impact.ledger, impact.seen, false, 0).empty());
  CHECK(energy_growth(impact.ledger, impact.seen, true, 0).empty());
  impact.ledger.external = 100;
  CHECK(energy_growth(impact.ledger, impact.seen, false, 0).empty());
  impact.ledger.internal = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(energy_growth(impact.ledger, impact.seen, false, 0).empty());
}

TEST_CASE("guards: what contact has taken of bodies that parted, and nothing while any touch") {
  Impact impact;
  impact.ledger.kinetic = 90;
  impact.ledger.contact = 8;
  CHECK(taken_by_parted(impact.ledger, impact.seen) == 0);  // none has met
  impact.ledger.contact_totals.push = 5;
  CHECK(taken_by_parted(impact.ledger, impact.seen) == Approx(0.08));
  impact.ledger.contact_totals.touching = 1;
  CHECK(taken_by_parted(impact.ledger, impact.seen) == 0);
}

TEST_CASE("guards: energy and momentum that the first step takes are a scale for what follows") {
  // a body at 1 m/s that a tie stops at once: v of the two half steps around t = 0 have no product
  Extremes seen;
  time::Ledger ledger;
  ledger.mass = 2;
  ledger.friction = 1;
  ledger.kinetic = 1e-14;
  ledger.impulse_given = {-2, 0, 0};
  ledger.momentum_scale = 1e-14;
  observe(ledger, seen);
  CHECK(judge(ledger, seen, 0).empty());
  ledger.friction -= 1e-15;
  ledger.impulse_given += Vec3(1e-15, 0, 0);
  observe(ledger, seen);
  CHECK(judge(ledger, seen, 0).empty());
  CHECK(error_ratio(seen) < 1e-14);
  CHECK(seen.momentum_error < 1e-14);
  ledger.contact = 1e-10;
  ledger.contact_totals.push = 1;
  CHECK(taken_by_parted(ledger, seen) < 1e-9);
}

TEST_CASE("guards: rounding of the first steps of a run from rest is judged by the largest energy of the run") {
  Extremes seen;
  time::Ledger ledger;
  observe(ledger, seen);
  CHECK(error_ratio(seen) == 0);
  ledger.kinetic = 1e-29;  // of nothing: 40000 times the energy that there is
  ledger.internal = -4e-25;
  observe(ledger, seen);
  ledger.external = 100;
  ledger.internal = 100 - 3e-14;
  ledger.kinetic = 0;
  observe(ledger, seen);
  CHECK(error_ratio(seen) < 1e-13);
  ledger.internal = 99;  // an error that is one stays
  observe(ledger, seen);
  ledger.internal = 100;
  observe(ledger, seen);
  CHECK(error_ratio(seen) == Approx(0.01));
}

TEST_CASE("guards: messages of a scene without deformable elements do not speak of elements or steps") {
  Impact impact;
  impact.ledger.kinetic = 1e6;
  const std::string growth = energy_growth(impact.ledger, impact.seen, false, 0, "contact");
  REQUIRE_FALSE(growth.empty());
  std::vector<std::string> texts{growth};
  for (const Fault fault : {Fault::balance, Fault::damping, Fault::friction, Fault::contact})
    texts.push_back(likely_cause(fault, "contact"));
  for (const std::string& text : texts)
    for (const char* word : {"element", "step", "cfl", "stress"}) {
      CAPTURE(text, word);
      CHECK(text.find(word) == std::string::npos);
    }
}

TEST_CASE("guards: angular momentum from contact is compared with momenta and impulses, whichever are larger") {
  Impact impact;
  impact.ledger.momentum_scale = 4;
  impact.ledger.contact_totals.spin = Vec3(0, 3, 4) * 1e-2;
  observe(impact.ledger, impact.seen);
  CHECK(angular_error(impact.ledger, impact.seen, 2) == Approx(5e-2 / 8));
  impact.ledger.contact_totals.push = 10;  // bodies at rest on each other for long
  CHECK(angular_error(impact.ledger, impact.seen, 2) == Approx(5e-2 / 20));
  CHECK(angular_error(time::Ledger{}, Extremes{}, 2) == 0);
}

TEST_CASE("guards: thresholds are those of the scene") {
  Impact impact;
  impact.ledger.contact = -5;
  impact.ledger.kinetic += 5;
  observe(impact.ledger, impact.seen);
  scene::Guards wide, tight;
  wide.energy_warning = 0.06;
  tight.energy_stop = 0.04;
  CHECK(judge(impact.ledger, impact.seen, 0, Gives::nothing, wide).empty());
  const std::vector<Finding> found = judge(impact.ledger, impact.seen, 0, Gives::nothing, tight);
  REQUIRE(found.size() == 1);
  CHECK(found[0].stop);
  impact.ledger.kinetic = 200;
  CHECK_FALSE(energy_growth(impact.ledger, impact.seen, false, 0).empty());
  wide.kinetic = 3;
  CHECK(energy_growth(impact.ledger, impact.seen, false, 0, {}, wide).empty());
}

TEST_CASE("guards: a whole run is judged by its largest energy, not by what there was at first touch") {
  Extremes seen;
  time::Ledger ledger;
  ledger.mass = 1;
  observe(ledger, seen);
  for (const auto& [internal, contact] : {std::pair{0.001, -0.0005}, std::pair{0.1, -0.004}, std::pair{1.0, 0.0}}) {
    ledger.internal = internal;
    ledger.contact = contact;
    ledger.external = internal + contact;
    observe(ledger, seen);
    note_worst(ledger, Gives::stored, internal, seen);
  }
  CHECK(judge_whole(seen, 0).empty());
  scene::Guards limits;
  limits.energy_warning = 0.003;
  const std::vector<Finding> found = judge_whole(seen, 0, limits);
  REQUIRE(found.size() == 1);
  CHECK(found[0].fault == Fault::contact);
  CHECK(found[0].share == Approx(0.004));
  CHECK_FALSE(found[0].stop);
  CHECK(seen.worst_time[static_cast<int>(Fault::contact)] == 0.1);
  CHECK(text_of(found[0], 0.1, "the largest energy of the run").find("% of the largest energy of the run") !=
        std::string::npos);
}
