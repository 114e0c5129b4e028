// SPDX-License-Identifier: Apache-2.0
// Who is slave, and who meets whom.
#include "contact/surface/surface.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <limits>

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("the finer side is slave, then the lighter, then the lower number; never both") {
  const std::vector<BodyFigures> bodies{
      {1.0, 5.0}, {0.5, 9.0}, {1.005, 2.0}, {1.0, 5.01}, {1.0, std::numeric_limits<double>::infinity()}};
  CHECK(is_slave(bodies, 1, 0));  // finer, though heavier
  CHECK(is_slave(bodies, 2, 0));  // as fine within 1 %, lighter
  CHECK(is_slave(bodies, 0, 3));  // alike: the lower number
  CHECK(is_slave(bodies, 3, 4));  // what cannot move is master
  for (std::int32_t a = 0; a < 5; ++a)
    for (std::int32_t b = 0; b < 5; ++b)
      if (a != b) CHECK(is_slave(bodies, a, b) != is_slave(bodies, b, a));
}

TEST_CASE("rules of pairs of blocks") {
  const std::vector<BodyFigures> bodies{{1.0, 5.0}, {0.5, 9.0}};
  Specification rules{.pairs = {3, {PairRule::automatic}}};
  const std::vector<std::int32_t> block0{0}, block1{1};
  CHECK(may_meet(rules, bodies, {block1, 1}, 0, 0));
  CHECK_FALSE(may_meet(rules, bodies, {block0, 0}, 1, 1));
  CHECK(may_meet(rules, bodies, {block1, 1}, 0, 1));  // one body with itself
  CHECK_FALSE(rules.pairs.forces_a_side());

  rules.pairs.set(0, 1, {PairRule::slave});
  CHECK(rules.pairs.at(1, 0).rule == PairRule::master);
  CHECK(may_meet(rules, bodies, {block0, 0}, 1, 1));
  CHECK_FALSE(may_meet(rules, bodies, {block1, 1}, 0, 0));
  CHECK(rules.pairs.forces_a_side());

  rules.pairs.set(1, 0, {});
  CHECK_FALSE(may_meet(rules, bodies, {block0, 0}, 1, 1));
  CHECK_FALSE(may_meet(rules, bodies, {block1, 1}, 0, 0));
  CHECK(may_meet(rules, bodies, {std::vector<std::int32_t>{1, 2}, 1}, 0, 0));  // through its other block
}

TEST_CASE("bodies that are never master, or never slave, are known") {
  const std::vector<BodyFigures> bodies{{1.0, 5.0}, {0.5, 9.0}, {2.0, 9.0}};
  const Roles roles = roles_of(bodies, Specification{.pairs = {3, {PairRule::automatic}}});
  CHECK(roles.slave == std::vector<char>{1, 1, 0});
  CHECK(roles.master == std::vector<char>{1, 0, 1});

  std::vector<BodyFigures> folding = bodies;
  folding[1].blocks = {2};  // may meet itself, so it is a master too
  CHECK(roles_of(folding, Specification{.pairs = {3, {PairRule::automatic}}}).master == std::vector<char>{1, 1, 1});
}

TEST_CASE("two passes: by order, or where neither side is much finer or lighter and none is named the slave") {
  constexpr double held = std::numeric_limits<double>::infinity();
  const std::vector<BodyFigures> bodies{
      {1.0, 5.0, {0}}, {0.52, 5.0, {1}}, {0.50, 5.0, {2}}, {1.0, 1.8, {3}}, {1.0, held, {4}}};  // 0.50: edges 1 : 1.414
  Specification rules{.pairs = {5, {PairRule::automatic}}};
  CHECK_FALSE(any_two_passes(rules, bodies));
  rules.pairs = {5, {PairRule::automatic, Passes::automatic}};
  const auto ways = [&](std::int32_t a, std::int32_t b) {  // a node on b's face, b's on a's, as edges do
    const std::vector<std::int32_t> own{a}, other{b};
    return std::array{may_meet(rules, bodies, {own, a}, b, b), may_meet(rules, bodies, {other, b}, a, a),
                      is_primary_slave(rules, bodies, {own, a}, b, b),
                      is_primary_slave(rules, bodies, {other, b}, a, a)};
  };
  using Ways = std::array<bool, 4>;
  CHECK(any_two_passes(rules, bodies));
  CHECK(ways(0, 1) == Ways{true, true, false, true});
  CHECK(ways(0, 2) == Ways{false, true, false, true});                                // too fine for its partner
  CHECK(ways(0, 3) == Ways{false, true, false, true});                                // too light
  CHECK(ways(0, 4) == Ways{true, false, true, false});                                // what cannot move is master
  CHECK(meet_in_two_passes(rules, bodies, {std::vector<std::int32_t>{0}, 0}, 0, 0));  // folds

  rules.pairs.set(2, 0, {PairRule::automatic, Passes::two});
  CHECK(ways(0, 2) == Ways{true, true, false, true});
  rules.pairs.set(0, 1, {PairRule::automatic, Passes::one});
  CHECK(ways(0, 1) == Ways{false, true, false, true});
  rules.pairs.set(0, 2, {});
  CHECK(ways(0, 2) == Ways{false, false, false, false});
  rules.pairs.set(1, 2, {PairRule::slave, Passes::automatic});
  CHECK(ways(1, 2) == Ways{true, false, true, false});
}

TEST_CASE("two passes: where the slave is finer on average, but not in every direction") {
  const std::vector<BodyFigures> bodies{{1.0, 5.0, {0}, 1.0, 1.0},
                                        {0.4, 5.0, {1}, 4.0, 0.1},   // long elements with small faces
                                        {0.25, 1.0, {2}, 0.5, 0.5},  // finer everywhere
                                        {4.0, 40.0, {3}, 12, 0.4}};  // graded: fine in the middle
  CHECK(is_finer_everywhere(bodies[2], bodies[0]));
  CHECK_FALSE(is_finer_everywhere(bodies[1], bodies[0]));
  Specification rules{.pairs = {4, {PairRule::automatic, Passes::automatic}}};
  const auto both = [&](std::int32_t a, std::int32_t b) {
    const std::vector<std::int32_t> own{a}, other{b};
    return may_meet(rules, bodies, {own, a}, b, b) && may_meet(rules, bodies, {other, b}, a, a);
  };
  CHECK(both(0, 1));
  CHECK_FALSE(both(0, 2));
  CHECK(both(0, 3));
  CHECK(both(2, 3));
}

TEST_CASE("bodies in two passes are slaves and masters") {
  const std::vector<BodyFigures> bodies{{1.0, 5.0, {0}}, {0.9, 5.0, {1}}};
  Specification rules{.pairs = {2, {PairRule::automatic}}};
  rules.pairs.set(0, 0, {});
  rules.pairs.set(1, 1, {});
  CHECK(roles_of(bodies, rules).slave == std::vector<char>{0, 1});
  rules.pairs.set(0, 1, {PairRule::automatic, Passes::automatic});
  CHECK(roles_of(bodies, rules).slave == std::vector<char>{1, 1});
  CHECK(roles_of(bodies, rules).master == std::vector<char>{1, 1});
}

TEST_CASE("nodes of the master on rims are held in one pass that was chosen by itself") {
  const std::vector<BodyFigures> bodies{{1.0, 5.0, {0}}, {0.1, 5.0, {1}}};  // the second is the slave
  Specification rules{.pairs = {2, {PairRule::automatic}}};
  rules.pairs.set(0, 0, {});
  rules.pairs.set(1, 1, {});
  rules.pairs.set(0, 1, {PairRule::automatic, Passes::automatic});
  const std::vector<std::int32_t> own{0};
  const auto may = [&](bool on_rim) { return may_meet(rules, bodies, {own, 0, on_rim}, 1, 1); };
  rules.enforcement.method = Method::kinematic;  // which does not hold the rows of two passes as one system
  CHECK_FALSE(may(true));
  rules.enforcement.method = Method::rate;
  CHECK(may(true));
  CHECK_FALSE(may(false));
  CHECK(any_two_passes(rules, bodies));
  const Roles roles = roles_of(bodies, rules);
  CHECK(roles.slave == std::vector<char>{0, 1});
  CHECK(roles.slave_rims[0] == 1);
  CHECK(roles.master == std::vector<char>{1, 1});
  rules.pairs.set(0, 1, {PairRule::automatic, Passes::one});
  CHECK_FALSE(may(true));
}
