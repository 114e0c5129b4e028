// SPDX-License-Identifier: Apache-2.0
// Surface nodes against a solid: another one, and their own.
#include "setup/solids.hpp"

#include <catch2/catch.hpp>

#include "mesh/primitives.hpp"
#include "unit/setup/bent_bar.hpp"

using namespace brunt;
using setup::Comparison;
using setup::Solid;

TEST_CASE("the nodes around a node are those of its elements") {
  const mesh::Mesh mesh = mesh::box("a", {3, 1, 1}, {3, 1, 1});
  const setup::NodesAround around(mesh);
  for (std::size_t n = 0; n < mesh.coordinates.size(); ++n) {
    const std::vector<LocalIndex> found = around.of(static_cast<LocalIndex>(n));
    const double x = mesh.coordinates[n].x();
    CHECK(found.size() == (x == 0 || x == 3 ? 8 : 12));
    CHECK(std::ranges::is_sorted(found));
    for (const LocalIndex other : found)
      CHECK(std::abs(mesh.coordinates[static_cast<std::size_t>(other)].x() - x) <= 1);
  }
}

TEST_CASE("a solid is not inside itself, however its elements are cut; a ring whose ends overlap is") {
  for (const double overlap : {-0.1, 0.0, 0.1}) {
    const mesh::Mesh mesh = test::bent_bar(overlap);
    const std::vector<Solid> solids = setup::solids_of(mesh);
    const setup::NodesAround around(mesh);
    const Comparison compared(mesh, solids[0], solids[0], mesh.blocks[0], &around);
    std::size_t overlapping = 0;
    for (std::size_t i = 0; i < compared.size(); ++i) {
      if (!compared.overlaps(i)) continue;
      ++overlapping;
      const auto behind = compared.behind_near(i);
      REQUIRE(behind);
      CHECK(test::is_bent_bar_depth(behind->penetration, overlap));
    }
    CHECK(overlapping == (overlap > 0 ? test::bent_bar_nodes : 0));
  }
}
