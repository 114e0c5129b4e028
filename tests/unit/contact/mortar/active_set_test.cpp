// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/active_set.hpp"

#include <catch2/catch.hpp>

#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("Rows are active where pressure outweighs the gap, and never without a segment") {
  MortarRows rows;
  MortarTopology topology;
  rows.covered = {1, 1, 1, 1, 0};
  rows.gaps = {-0.01, 0.01, 0.01, 0.0, 0.0};
  topology.edge = 0.5;
  const double c = layer_stiffness(100, topology);
  CHECK(c == 200);
  const std::vector<double> z{0, 1, 3, 0, 1};
  std::vector<std::uint8_t> active;
  CHECK(choose_active(rows, z, c, active) == 2);
  CHECK(active == std::vector<std::uint8_t>{1, 0, 1, 0, 0});
  CHECK(choose_active(rows, z, c, active) == 0);
  // rows that keep a gap below zero; over what is covered, so that a sliver counts like a whole row
  CHECK(choose_active(rows, z, c, active, std::vector<double>{-0.02, 0, 0, 0, 0}) == 1);
  CHECK(active == std::vector<std::uint8_t>{0, 0, 1, 0, 0});
  rows.covered[2] = 1e-3;
  CHECK(choose_active(rows, z, c, active) == 2);
  CHECK(active == std::vector<std::uint8_t>{1, 0, 0, 0, 0});
}
