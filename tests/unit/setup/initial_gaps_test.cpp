// SPDX-License-Identifier: Apache-2.0
// Gaps and overlaps of two cubes at known places: depth and count.
#include "setup/initial_gaps.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "unit/setup/bent_bar.hpp"
#include "unit/setup/rules.hpp"

using namespace brunt;
using setup::InitialGaps;
using setup::OverlapRule;

namespace {

/// A unit cube of 2^3 elements, and one of 4^3 shifted by `x` and by 0.1 to the side.
InitialGaps gaps_of_cubes(double x) {
  mesh::Mesh mesh = mesh::box("a", Vec3(1, 1, 1), {2, 2, 2});
  mesh::Mesh other = mesh::box("b", Vec3(1, 1, 1), {4, 4, 4});
  mesh::place(other, 1, Vec3(0, 0, 1), 0, Vec3(x, 0.1, 0.1));
  mesh::append(mesh, std::move(other), "");
  return setup::initial_gaps(mesh, test::all_touch(2, OverlapRule::error, true));
}

InitialGaps gaps_of_bar(double overlap, bool self) {
  return setup::initial_gaps(test::bent_bar(overlap), test::all_touch(1, OverlapRule::error, self));
}

}  // namespace

TEST_CASE("initial gaps: the smallest distance of a node to a face of the other part") {
  CHECK(gaps_of_cubes(1.125).smallest == Approx(0.125));
  CHECK(gaps_of_cubes(1.0).smallest == 0);
  CHECK(gaps_of_cubes(4.0).smallest == -1);  // nothing within an edge
  CHECK(gaps_of_cubes(1.125).overlaps.empty());
}

TEST_CASE("initial gaps: nodes inside the other body with their depth") {
  const InitialGaps gaps = gaps_of_cubes(0.875);
  // of b the end of 5 x 5 nodes at x = 0.875, less those at y or z = 1.1: 4 x 4; of a the end of 3 x 3 less those at 0:
  // 2 x 2
  CHECK(gaps.overlaps.size() == 4 * 4 + 2 * 2);
  CHECK(gaps.overlaps.front().penetration == Approx(0.125));
  for (const setup::InitialOverlap& overlap : gaps.overlaps) CHECK(overlap.face[0] != no_index);
}

TEST_CASE("initial gaps: a body that overlaps itself is told, where parts meet themselves") {
  const InitialGaps gaps = gaps_of_bar(0.1, true);
  REQUIRE(gaps.overlaps.size() == test::bent_bar_nodes);
  for (const setup::InitialOverlap& overlap : gaps.overlaps) {
    CHECK(overlap.is_within_itself());
    CHECK(test::is_bent_bar_depth(overlap.penetration, 0.1));
    CHECK_FALSE(overlap.too_deep);
    CHECK(overlap.rule == OverlapRule::error);
  }
  CHECK(gaps.piercings.empty());
  CHECK(gaps.smallest == -1);  // a body is at no distance from itself
  CHECK(gaps_of_bar(0.1, false).overlaps.empty());
  CHECK(gaps_of_bar(-0.1, true).overlaps.empty());
  // an end face of edge 0.5 lets nodes be 0.125 deep
  const InitialGaps deep = gaps_of_bar(0.2, true);
  REQUIRE(deep.overlaps.size() == test::bent_bar_nodes);
  CHECK(deep.overlaps[0].too_deep);
}
