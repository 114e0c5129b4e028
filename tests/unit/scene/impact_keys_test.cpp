// SPDX-License-Identifier: Apache-2.0
// enforcement.impact: how it is given, and what cannot return energy.
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "scene/read/read.hpp"
#include "unit/scene/good_scene.hpp"

using namespace brunt;
using namespace brunt::scene;
using contact::Impact;

namespace {

Input read_with(const std::vector<std::string>& overrides) {
  return read_scene(std::string(small_scene), "bar.yaml", overrides);
}

std::string fault_of(const std::vector<std::string>& overrides) {
  try {
    read_with(overrides);
  } catch (const InputError& error) {
    REQUIRE(error.faults().size() == 1);
    return error.faults()[0];
  }
  return {};
}

}  // namespace

TEST_CASE("impacts are plastic unless the scene says otherwise, in the section or in an entry", "[scene]") {
  CHECK(read_with({}).enforcement.settings.impact == Impact::plastic);
  CHECK(read_with({"enforcement.impact=elastic"}).enforcement.settings.impact == Impact::elastic);
  const Input entry = read_with({"contact.0.impact=elastic", "contact.0.method=row_sum", "contact.0.slave=auto"});
  CHECK(entry.enforcement.settings.impact == Impact::elastic);
  CHECK(entry.warnings.empty());
  CHECK(read_with({"contact=null", "enforcement.impact=elastic"}).enforcement.settings.impact == Impact::elastic);
  CHECK(read_with({"enforcement.impact=plastic", "enforcement.method=penalty"}).warnings.empty());
}

TEST_CASE("what does not hold the rates of all rows in one system cannot return energy", "[scene]") {
  using Catch::Contains;
  CHECK_THAT(fault_of({"enforcement.impact=soft"}), Contains("unknown value 'soft'") && Contains("plastic, elastic"));
  for (const std::string method : {"penalty", "gap_penalty", "kinematic", "printed", "reference"})
    CHECK_THAT(fault_of({"enforcement.impact=elastic", "enforcement.method=" + method}),
               Contains("enforcement.impact: invalid impact elastic with method " + method) &&
                   Contains("expected method rate or row_sum, or impact plastic"));
  CHECK_THAT(fault_of({"contact.0.slave=auto", "contact.0.impact=elastic", "contact.0.passes=averaged"}),
             Contains("contact.0.impact: invalid impact elastic with passes averaged") &&
                 Contains("expected passes auto, one, two or mortar"));
  CHECK_THAT(fault_of({"contact.0.impact=elastic", "enforcement.impact=plastic"}),
             Contains("expected the same value in both places"));
}
