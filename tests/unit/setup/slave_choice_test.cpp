// SPDX-License-Identifier: Apache-2.0
// The slave foretold: the finer of two bodies, or the one that the rules name.
#include "setup/slave_choice.hpp"

#include <array>
#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "unit/setup/rules.hpp"

using namespace brunt;

namespace {

/// Which of block 0 (coarse) and block 1 (fine) may be slave of the other.
std::array<bool, 2> slaves(contact::PairRule rule) {
  mesh::Mesh mesh = mesh::box("coarse", {1, 1, 1}, {1, 1, 1});
  mesh::Mesh fine = mesh::box("fine", {1, 1, 1}, {3, 3, 3});
  mesh::place(fine, 1, {0, 0, 1}, 0, {0, 0, 1.1});
  mesh::append(mesh, std::move(fine));
  setup::StartRules rules = test::all_touch(2, setup::OverlapRule::error, false);
  rules.contact.pairs.set(0, 1, {rule});
  const setup::SlaveChoice choice(mesh, rules);
  return {choice.is_slave(0, 0, 1, 1), choice.is_slave(1, 1, 0, 0)};
}

}  // namespace

TEST_CASE("slave choice: the finer body, unless the rules say which") {
  CHECK(slaves(contact::PairRule::automatic) == std::array{false, true});
  CHECK(slaves(contact::PairRule::slave) == std::array{true, false});
  CHECK(slaves(contact::PairRule::master) == std::array{false, true});
  CHECK(slaves(contact::PairRule::apart) == std::array{false, false});
}
