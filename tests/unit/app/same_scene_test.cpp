// SPDX-License-Identifier: Apache-2.0
// Files of another scene are refused with the keys that differ.
#include "app/whole/same_scene.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"

using namespace brunt;

TEST_CASE("same scene: the keys that differ are named") {
  CHECK_NOTHROW(app::refuse_other_scene("f.h5", {"1", "a=1\n"}, {"1", "a=2\n"}));
  CHECK_NOTHROW(app::refuse_other_scene("f.h5", {"1", ""}, {"2", "a=2\n"}));
  CHECK_NOTHROW(app::refuse_other_scene("f.h5", {"1", "a=1\n"}, {"2", "a=1\n"}));
  CHECK_THROWS_WITH(
      app::refuse_other_scene("f.h5", {"1", "a=1\nb=2\n"}, {"2", "a=3\nb=2\n"}),
      Catch::Contains(
          "f.h5: invalid for this scene: written by another one: a is 1 in the earlier run and 3 in this scene"));
}
