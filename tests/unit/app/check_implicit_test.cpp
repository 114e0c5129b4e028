// SPDX-License-Identifier: Apache-2.0
// Durations as brunt check tells them.
#include "app/check/check_implicit.hpp"

#include <catch2/catch.hpp>

using brunt::app::duration_text;

TEST_CASE("durations are told in the unit that fits them") {
  CHECK(duration_text(0.5) == "0.5 s");
  CHECK(duration_text(119) == "119 s");
  CHECK(duration_text(120) == "2 min");
  CHECK(duration_text(7199) == "120 min");
  CHECK(duration_text(7200) == "2.0 h");
  CHECK(duration_text(86400 * 365.0) == "365 days");
}
