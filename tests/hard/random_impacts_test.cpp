// SPDX-License-Identifier: Apache-2.0
// Bodies of random shape, mesh, attitude and speed run into each other, corners, edges and rims first. They are judged
// by true depth, of nodes in elements and of points on edges: contact reports no penetration that is not there and none
// less than there is, conserves momentum and gives no energy.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <string>

#include "support/impacts.hpp"

using namespace brunt;

namespace {

/// Criteria set in advance: tests/hard/README.md. Runs that miss one are held in tests/regression.
void check(const std::string& passes, unsigned seed) {
  const test::ImpactFigures f = test::run_impact(seed, passes);
  CAPTURE(passes, seed, f.reported, f.held, f.held_middle, f.not_reported, f.others, f.edges, f.contact_steps);
  for (const test::Criterion criterion : test::criteria) {
    CAPTURE(static_cast<int>(criterion));
    if (!test::is_judged(criterion, passes) || test::is_missed(criterion, passes, seed)) continue;
    CHECK(test::figure_of(f, criterion) <= test::limit_of(criterion));
  }
  CHECK(f.momentum <= 1e-12);
  CHECK(f.error <= 1e-10);
}

}  // namespace

TEST_CASE("random impacts: reported depths are true ones, nodes do not sink in, energy and momentum stay", "[law]") {
  const std::string passes = GENERATE("one", "two");
  for (unsigned seed = 1; seed <= 10; ++seed) check(passes, seed);
}

TEST_CASE("three hundred random impacts in one, two and automatic passes", "[.][long][law]") {
  const std::string passes = GENERATE("one", "two", "auto");
  for (unsigned seed = 1; seed <= 300; ++seed) check(passes, seed);
}

TEST_CASE("random impacts: the table of all figures", "[.][table]") {
  fmt::print(
      "passes seed reported not_there held middle not_reported others edges given returned error momentum at steps\n");
  for (const std::string passes : {"one", "two", "auto"})
    DYNAMIC_SECTION(passes) for (unsigned seed = 1; seed <= 300; ++seed) {
      const test::ImpactFigures f = test::run_impact(seed, passes);
      fmt::print("{} {} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {:.3e} {}\n",
                 passes, seed, f.reported, f.not_there, f.held, f.held_middle, f.not_reported, f.others, f.edges,
                 f.given, f.returned, f.error, f.momentum, f.held_at, f.contact_steps);
      std::fflush(stdout);
    }
  SUCCEED();
}

// Goes into support/missed_impacts.cpp.
TEST_CASE("random impacts: the list of those that miss a criterion", "[.][table]") {
  constexpr std::array names{"depth", "reports", "energy", "given", "edges"};
  for (const std::string passes : {"one", "two", "auto"})
    for (unsigned seed = 1; seed <= 300; ++seed) {
      const test::ImpactFigures f = test::run_impact(seed, passes);
      for (const test::Criterion criterion : test::criteria)
        if (const double figure = test::figure_of(f, criterion);
            test::is_judged(criterion, passes) && figure > test::limit_of(criterion))
          fmt::print("{{{}, \"{}\", {}, {:.4g}}},\n", names[static_cast<std::size_t>(criterion)], passes, seed, figure);
    }
  SUCCEED();
}
