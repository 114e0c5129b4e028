// SPDX-License-Identifier: Apache-2.0
#include "contact/surface/passes.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("rows of two bodies are of the pass of their slave, rows within a body of that of their numbers") {
  const std::vector<BodyFigures> bodies{{1.0, 5.0, {0}}, {0.9, 5.0, {1}}};
  Specification rules{.pairs = {2, {PairRule::automatic}}};
  const std::vector<std::int32_t> block0{0}, block1{1};
  Row onto_coarse{.slave_body = 1, .master_body = 0, .master_block = 0, .normal = Vec3::UnitZ()};
  Row onto_fine{.slave_body = 0, .master_body = 1, .master_block = 1, .normal = -Vec3::UnitZ()};
  CHECK(pass_of(onto_coarse, {block1, 1}, 10, rules, bodies) ==
        Pass::both);  // one pass unless the table says otherwise

  rules.pairs.set(0, 1, {PairRule::automatic, Passes::automatic});
  CHECK(pass_of(onto_coarse, {block1, 1}, 10, rules, bodies) == Pass::first);
  CHECK(pass_of(onto_fine, {block0, 0}, 10, rules, bodies) == Pass::second);
  rules.pairs.set(0, 1, {PairRule::slave, Passes::automatic});  // who names a slave wants one pass
  CHECK(pass_of(onto_fine, {block0, 0}, 10, rules, bodies) == Pass::both);
  rules.pairs.set(0, 1, {PairRule::slave, Passes::two});
  CHECK(pass_of(onto_fine, {block0, 0}, 10, rules, bodies) == Pass::first);
  CHECK(pass_of(onto_coarse, {block1, 1}, 10, rules, bodies) == Pass::second);

  Row fold = onto_coarse;
  fold.slave_body = 0;
  CHECK(pass_of(fold, {block0, 0}, 10, rules, bodies) == Pass::both);
  rules.pairs.set(0, 0, {PairRule::automatic, Passes::automatic});
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(-0.6, 0.8, 0)}) {  // no direction of space decides
    fold.normal = normal;
    fold.key.slave = 9;
    CHECK(pass_of(fold, {block0, 0}, 10, rules, bodies) == Pass::first);
    fold.key.slave = 11;
    CHECK(pass_of(fold, {block0, 0}, 10, rules, bodies) == Pass::second);
  }
}
