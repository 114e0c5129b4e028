// SPDX-License-Identifier: Apache-2.0
// Figures in messages.
#include "app/log.hpp"

#include <catch2/catch.hpp>

using brunt::app::told_from;

TEST_CASE("log: a figure above a limit is never written as the limit") {
  CHECK(told_from(0.25, 1e-3) == "0.25");
  CHECK(told_from(0.0123456, 1e-3) == "0.012");  // no more digits than it takes
  CHECK(told_from(0.00100049, 1e-3) == "0.0010005");
  CHECK(told_from(1.00000000000002e-4, 1e-4) != "0.0001");
  CHECK(told_from(1e-3, 1e-3) == "0.001");  // nothing to tell
}
