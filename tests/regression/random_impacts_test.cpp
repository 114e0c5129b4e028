// SPDX-License-Identifier: Apache-2.0
// Random impacts that miss a criterion of tests/hard: they get no worse.
#include <catch2/catch.hpp>
#include <string>

#include "support/impacts.hpp"

using namespace brunt;

namespace {

void check_missed(unsigned last_seed, const std::string& but) {
  constexpr double margin = 1.3;  // times our figure: what rounding in another order makes of a run
  int missed_here = 0;
  for (const test::MissedImpact& missed : test::missed_impacts()) {
    if (missed.seed > last_seed || missed.passes == but) continue;
    ++missed_here;
    const double figure = test::figure_of(test::run_impact(missed.seed, missed.passes), missed.criterion);
    CAPTURE(missed.passes, missed.seed, static_cast<int>(missed.criterion), missed.ours, figure);
    CHECK(figure > test::limit_of(missed.criterion));  // else it is missed no more, and leaves the list
    CHECK(figure <= margin * missed.ours);
  }
  CHECK(missed_here > 0);
}

}  // namespace

// ours: by seed in support/missed_impacts.cpp
TEST_CASE("random impacts that miss a criterion of depth or energy get no worse", "[regression]") {
  check_missed(60, "auto");
}

// ours: by seed in support/missed_impacts.cpp
TEST_CASE("of three hundred random impacts those that miss a criterion get no worse", "[.][long][regression]") {
  check_missed(300, "");
}
