// SPDX-License-Identifier: Apache-2.0
// The small pieces reading stands on: curves, durations, units, nearest words.
#include <catch2/catch.hpp>

#include "scene/curve.hpp"
#include "scene/input.hpp"
#include "scene/text/duration.hpp"
#include "scene/text/nearest.hpp"
#include "scene/text/units.hpp"

using namespace brunt::scene;

TEST_CASE("a curve is linear between its points and constant beyond", "[scene]") {
  const Curve curve{{1, 10}, {2, 20}, {4, 0}};
  CHECK(value_at(curve, -5) == 10);
  CHECK(value_at(curve, 1) == 10);
  CHECK(value_at(curve, 1.25) == 12.5);
  CHECK(value_at(curve, 2) == 20);
  CHECK(value_at(curve, 3) == 10);
  CHECK(value_at(curve, 4) == 0);
  CHECK(value_at(curve, 1e300) == 0);
  CHECK(value_at(Curve{{0, 7}}, 3) == 7);
}

TEST_CASE("durations as people write them", "[scene]") {
  CHECK(parse_duration("3h55m") == 14100.0);
  CHECK(parse_duration("90s") == 90.0);
  CHECK(parse_duration("2h") == 7200.0);
  CHECK(parse_duration("1d1s") == 86401.0);
  CHECK(parse_duration("1m30.5s") == 90.5);
  CHECK(parse_duration("45") == 45.0);
  for (const char* bad : {"", "0", "-5", "5x", "m", "5m3h", "3h3h", "3h5", "inf", "nan", "1e400s"}) {
    INFO(bad);
    CHECK_FALSE(parse_duration(bad));
  }
}

TEST_CASE("each unit system is consistent", "[scene]") {
  // sizes in SI of the units named, from their definitions
  const auto size = [](const std::string& unit) {
    const std::vector<std::pair<std::string, double>> known{{"N", 1},
                                                            {"kN", 1e3},
                                                            {"MN", 1e6},
                                                            {"1e7 N", 1e7},
                                                            {"dyn", 1e-5},
                                                            {"lbf", 4.4482216152605},
                                                            {"J", 1},
                                                            {"mJ", 1e-3},
                                                            {"kJ", 1e3},
                                                            {"1e5 J", 1e5},
                                                            {"erg", 1e-7},
                                                            {"in.lbf", 0.1129848290276167},
                                                            {"ft.lbf", 1.3558179483314004},
                                                            {"Pa", 1},
                                                            {"MPa", 1e6},
                                                            {"GPa", 1e9},
                                                            {"TPa", 1e12},
                                                            {"Mbar", 1e11},
                                                            {"dyn/cm^2", 0.1},
                                                            {"psi", 6894.757293168361},
                                                            {"psf", 47.88025898033584},
                                                            {"N.s", 1},
                                                            {"N.ms", 1e-3},
                                                            {"g.cm/us", 10},
                                                            {"dyn.s", 1e-5},
                                                            {"lbf.s", 4.4482216152605}};
    for (const auto& [name, value] : known) {
      if (name == unit) return value;
    }
    return 0.0;
  };
  REQUIRE(unit_systems().size() == 10);
  for (const UnitSystem& units : unit_systems()) {
    INFO(units.name);
    CHECK(find_unit_system(units.name) == &units);
    if (units.name == "none") continue;
    const double force = units.kilogram * units.metre / (units.second * units.second);
    CHECK(size(units.force) == Approx(force).epsilon(1e-12));
    CHECK(size(units.energy) == Approx(force * units.metre).epsilon(1e-12));
    CHECK(size(units.stress) == Approx(force / (units.metre * units.metre)).epsilon(1e-12));
    CHECK(size(units.momentum) == Approx(force * units.second).epsilon(1e-12));
  }
  CHECK(find_unit_system("furlong") == nullptr);
}

TEST_CASE("the nearest known word", "[scene]") {
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);  // Levenshtein's example
  CHECK(edit_distance("yeild", "yield") == 1);     // a swap is one slip
  CHECK(edit_distance("SI", "si") == 0);
  const std::vector<std::string> known{"density", "young", "poisson"};
  CHECK(nearest("possion", known) == "poisson");
  CHECK(nearest("young_modulus", known) == "young");
  CHECK(nearest("x", {}).empty());
  CHECK(listed(known) == "density, young, poisson");
  CHECK(did_you_mean("possion", known) == " (did you mean 'poisson'?)");
  CHECK(did_you_mean("colour", known).empty());
  CHECK(did_you_mean("x", {}).empty());
  CHECK(is_near("si", "SI"));
  CHECK_FALSE(is_near("mm", "SI"));
  CHECK_FALSE(is_near("nodes", "dofs"));
}
