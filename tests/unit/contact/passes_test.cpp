// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/passes.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("rows of two bodies are of the pass of their slave, rows within a body of the side they look to") {
  const std::vector<BodyFigures> bodies{{1.0, 5.0, {0}}, {0.9, 5.0, {1}}};
  PairTable pairs(2, PairRule::automatic);
  const std::vector<std::int32_t> block0{0}, block1{1};
  Row onto_coarse{.slave_body = 1, .master_body = 0, .master_block = 0, .normal = Vec3::UnitZ()};
  Row onto_fine{.slave_body = 0, .master_body = 1, .master_block = 1, .normal = -Vec3::UnitZ()};
  CHECK(pass_of(onto_coarse, {block1, 1}, pairs, bodies) == Pass::both);  // one pass unless the table says otherwise

  pairs.set_passes(0, 1, Passes::automatic);
  CHECK(pass_of(onto_coarse, {block1, 1}, pairs, bodies) == Pass::first);
  CHECK(pass_of(onto_fine, {block0, 0}, pairs, bodies) == Pass::second);
  pairs.set(0, 1, PairRule::slave);  // who names a slave wants one pass
  CHECK(pass_of(onto_fine, {block0, 0}, pairs, bodies) == Pass::both);
  pairs.set_passes(0, 1, Passes::two);
  CHECK(pass_of(onto_fine, {block0, 0}, pairs, bodies) == Pass::first);
  CHECK(pass_of(onto_coarse, {block1, 1}, pairs, bodies) == Pass::second);

  Row fold = onto_coarse;
  fold.slave_body = 0;
  CHECK(pass_of(fold, {block0, 0}, pairs, bodies) == Pass::both);
  pairs.set_passes(0, 0, Passes::automatic);
  const Pass upward = pass_of(fold, {block0, 0}, pairs, bodies);
  fold.normal = -fold.normal;
  const Pass downward = pass_of(fold, {block0, 0}, pairs, bodies);
  CHECK(upward != Pass::both);
  CHECK(downward != Pass::both);
  CHECK(upward != downward);
}
