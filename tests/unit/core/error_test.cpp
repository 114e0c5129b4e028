// SPDX-License-Identifier: Apache-2.0
// Faults of the input line by line; faults of our own are told from them.
#include "core/error.hpp"

#include <catch2/catch.hpp>

using namespace brunt;

TEST_CASE("an input error says all its faults, a line each, and keeps them apart") {
  const std::vector<std::string> faults{"scene.yaml:3: mesh: missing", "scene.yaml:7: run.end: is negative"};
  const InputError several(faults), one("only this");
  CHECK(several.faults() == faults);
  CHECK(std::string(several.what()) == faults[0] + "\n" + faults[1]);
  CHECK(one.faults() == std::vector<std::string>{"only this"});
  CHECK(std::string(one.what()) == "only this");
}

TEST_CASE("a broken precondition is a bug of ours: no kind of error that the user is blamed for") {
  CHECK_NOTHROW(demand(true, "nothing"));
  CHECK_THROWS_AS(demand(false, "the face is there"), std::logic_error);  // InputError and its like are runtime errors
  CHECK_THROWS_WITH(demand(false, "the face is there"),
                    Catch::Contains("please report") && Catch::Contains("the face is there"));
}
