// SPDX-License-Identifier: Apache-2.0
// Where parts lie.
#include "app/check/part_extents.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("extents: of each part, and of all, far from the origin as near") {
  for (const double far : {0.0, 1.0e6, -3.0e3}) {
    std::string text = support::two_bodies;
    for (const std::string& at : {std::string("elements: [2, 2, 1]}"), std::string("at: [0.5, 0.5, 1]}")})
      text.replace(text.find(at), at.size(),
                   at.starts_with("at") ? "at: [" + std::to_string(far + 0.5) + ", 0.5, 1]}"
                                        : "elements: [2, 2, 1], at: [" + std::to_string(far) + ", 0, 0]}");
    const support::PreparedScene scene(text);
    const std::vector<app::Extent> extents = app::part_extents(*scene.run);
    REQUIRE(extents.size() == 2);
    CHECK(extents[0].low == std::array{far, 0.0, 0.0});
    CHECK(extents[0].high == std::array{far + 2, 2.0, 1.0});
    CHECK(extents[1].low == std::array{far + 0.5, 0.5, 1.0});
    CHECK(extents[1].high == std::array{far + 1.5, 1.5, 2.0});
    const app::Extent all = app::together(extents);
    CHECK(all.low == std::array{far, 0.0, 0.0});
    CHECK(all.high == std::array{far + 2, 2.0, 2.0});
    CHECK_FALSE(std::signbit(extents[0].low[1]));
  }
}
