// SPDX-License-Identifier: Apache-2.0
// Words for parts that supports move through each other or through a wall.
#include "app/state/driven_words.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using Catch::Contains;

TEST_CASE("parts that supports move through each other, and through a wall, are named") {
  model::Model model;
  model.blocks.resize(2);
  model.blocks[0].part = "low";
  model.blocks[1].part = "top";
  model.touching.walls.emplace_back().name = "ram";
  CHECK(app::driven_pair(model, 0, 1) == "part 'low' and part 'top'");
  CHECK(app::driven_pair(model, 1, -1) == "part 'top' and rigid wall 'ram'");
  CHECK_THAT(app::driven_through(model, 0, 1, 0.1, 0.01, "mm"),
             Contains("part 'low' and part 'top' through each other: since t = 0.1 ") && Contains("faces") &&
                 Contains("now 0.01 mm."));
  CHECK_THAT(app::driven_through(model, 0, -1, 0.1, 0.01, ""), Contains("behind a wall") && Contains("now 0.01."));
}
