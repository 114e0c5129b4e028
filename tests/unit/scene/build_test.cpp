// SPDX-License-Identifier: Apache-2.0
// What the entries of `contact` come to for each pair of blocks.
#include "scene/build/build.hpp"

#include <catch2/catch.hpp>

#include "scene/read/read.hpp"
#include "unit/scene/good_scene.hpp"

using namespace brunt;
using namespace brunt::scene;
using contact::Tied;

namespace {

Input scene_with(const std::string& contact) {
  const std::vector<std::string> overrides{"contact=" + contact};
  return read_scene(std::string(small_scene), "small.yaml", overrides);
}

/// Of the pair (left, right).
struct Rule {
  Tied tied = Tied::no;
  contact::PairRule rule = contact::PairRule::apart;
  double friction = 0;
  std::optional<contact::OverlapRule> overlap;
};

Rule rule_of(const std::string& contact) {
  const Input input = scene_with(contact);
  const contact::PairSpecification pair =
      contact_specification(input, std::vector<std::string>{"left", "right"}).pairs.at(0, 1);
  return {pair.tied, pair.rule, pair.friction.fixed, overlap_rule(input, "left", "right")};
}

using Overlap = contact::OverlapRule;

}  // namespace

TEST_CASE("tied parts stay tied under general contact, before it or after it", "[scene]") {
  for (const char* contact : {"[{between: [left, right], tied: true, slave: right}, {between: all, friction: 0.2}]",
                              "[{between: all, friction: 0.2}, {between: [right, left], tied: true, slave: right}]"}) {
    CAPTURE(contact);
    const Rule rule = rule_of(contact);
    CHECK(rule.tied == Tied::yes);
    CHECK(rule.rule == contact::PairRule::master);  // left, as seen from it
    CHECK(rule.overlap == Overlap::offset);
  }
  CHECK(rule_of("[{between: [left, right], tied: true}, {between: all, friction: 0.2}]").friction == 0.2);
}

TEST_CASE("tied parts that general contact excludes have their ties and nothing else", "[scene]") {
  const Rule rule = rule_of("[{between: [left, right], tied: true}, {between: all, exclude: [[right, left]]}]");
  CHECK(rule.tied == Tied::alone);
  CHECK(rule.rule == contact::PairRule::automatic);
  CHECK(rule.overlap == Overlap::offset);
  CHECK(rule_of("[{between: all, exclude: [[right, left]]}, {between: [left, right], tied: true}]").tied == Tied::yes);
}

TEST_CASE("an entry that names tied parts unties them, with a warning unless it says so", "[scene]") {
  const std::string tied = "[{between: [left, right], tied: true}, {between: all}, ";
  const Rule rule = rule_of(tied + "{between: [right, left]}]");
  CHECK(rule.tied == Tied::no);
  CHECK(rule.overlap == Overlap::error);
  const Input told = scene_with(tied + "{between: [right, left]}]");
  REQUIRE(told.warnings.size() == 1);
  CHECK_THAT(told.warnings[0],
             Catch::Contains("contact.2: this entry releases the tie of right and left defined by contact.0"));
  CHECK(scene_with(tied + "{between: [right, left], tied: false}]").warnings.empty());
  CHECK(scene_with(tied + "{between: [left, left]}]").warnings.empty());
  CHECK(scene_with("[{between: [left, right]}, {between: [left, right]}]").warnings.empty());
}

TEST_CASE("pairs that no entry lets meet stay apart, a named slave is one seen from either side", "[scene]") {
  const std::vector<std::string> parts{"left", "right", "left"};  // a part of two blocks
  const auto rule = [&](const std::string& contact, std::int32_t a, std::int32_t b) {
    return contact_specification(scene_with(contact), parts).pairs.at(a, b).rule;
  };
  using contact::PairRule;
  const std::string named = "[{between: [right, left], slave: right}]";
  CHECK(rule(named, 0, 0) == PairRule::apart);
  CHECK(rule(named, 0, 2) == PairRule::apart);
  CHECK(rule(named, 0, 1) == PairRule::master);
  CHECK(rule(named, 1, 0) == PairRule::slave);
  CHECK(rule(named, 1, 2) == PairRule::slave);
  const std::string all = "[{between: all, self: false}]";
  CHECK(rule(all, 0, 1) == PairRule::automatic);
  CHECK(rule(all, 1, 0) == PairRule::automatic);
  CHECK(rule(all, 1, 1) == PairRule::apart);
}

TEST_CASE(
    "contact with a part that erodes has two passes, unless its entry tells them, names a slave or lets friction lag",
    "[scene]") {
  const auto passes = [](const std::string& contact, const std::string& erosion) {
    std::vector<std::string> overrides{"contact=" + contact};
    if (!erosion.empty()) overrides.push_back("parts.right.erosion=" + erosion);
    const Input input = read_scene(std::string(small_scene), "small.yaml", overrides);
    return contact_specification(input, std::vector<std::string>{"left", "right"}).pairs.at(0, 1).passes;
  };
  using contact::Passes;
  const std::string erodes = "{plastic_strain: 0.5}", all = "[{between: all}]";
  CHECK(passes(all, "") == Passes::automatic);
  CHECK(passes(all, erodes) == Passes::two);
  CHECK(passes("[{between: all, passes: one}]", erodes) == Passes::one);
  CHECK(passes("[{between: [left, right], slave: right}]", erodes) == Passes::automatic);
  CHECK(passes("[{between: [left, right], tied: true}]", erodes) == Passes::one);
  CHECK(passes("[{between: all, friction: {static: 0.3, lag: 1.0e-6}}]", erodes) == Passes::one);
}
