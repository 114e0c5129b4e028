// SPDX-License-Identifier: Apache-2.0
// Gaps and overlaps of two cubes at known places: depth, count, and what is said of them.
#include "app/initial_gaps.hpp"

#include <catch2/catch.hpp>

#include "app/overlap_report.hpp"
#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
#include "brunt/scene/read.hpp"
#include "unit/app/bent_bar.hpp"

using namespace brunt;

namespace {

/// A unit cube of 2^3 elements, and one of 4^3 shifted by `x` and by 0.1 to the side.
struct Cubes {
  scene::Input input;
  mesh::Mesh mesh;
  Cubes(double x, const std::string& rule)
      : input(scene::read_scene("units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
                                "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
                                "parts: {a: {material: m}, b: {material: m}}\n"
                                "contact: [{between: all, initial_overlap: " +
                                    rule + "}]\n",
                                "scene of the test")) {
    mesh::append(mesh, mesh::box("a", Vec3(1, 1, 1), {2, 2, 2}), "");
    mesh::Mesh other = mesh::box("b", Vec3(1, 1, 1), {4, 4, 4});
    mesh::place(other, 1, Vec3(0, 0, 1), 0, Vec3(x, 0.1, 0.1));
    mesh::append(mesh, std::move(other), "");
  }
  [[nodiscard]] app::InitialGaps gaps() const { return app::initial_gaps(input, mesh); }
};

}  // namespace

TEST_CASE("initial gaps: the smallest distance of a node to a face of the other part") {
  CHECK(Cubes(1.125, "error").gaps().smallest == Approx(0.125));
  CHECK(Cubes(1.0, "error").gaps().smallest == 0);
  CHECK(Cubes(4.0, "error").gaps().smallest == -1);  // nothing within an edge
  CHECK(Cubes(1.125, "error").gaps().overlaps.empty());
}

TEST_CASE("initial gaps: nodes inside the other body with their depth, one line for the pair") {
  const Cubes cubes(0.875, "error");
  const app::InitialGaps gaps = cubes.gaps();
  // of b the end of 5 x 5 nodes at x = 0.875, less those at y or z = 1.1: 4 x 4; of a the end of 3 x 3 less those at 0:
  // 2 x 2
  CHECK(gaps.overlaps.size() == 4 * 4 + 2 * 2);
  CHECK(gaps.overlaps.front().depth == Approx(0.125));
  const app::OverlapReport report = app::report_overlaps(cubes.input, cubes.mesh, gaps);
  REQUIRE(report.faults.size() == 2);  // one line for the pair, and advice
  CHECK(report.warnings.empty());
  CHECK_THAT(report.faults[0], Catch::Contains("lies 0.125 inside part") && Catch::Contains("the deepest of 20 nodes"));
  CHECK(report.list.size() == 20);
  CHECK_THAT(report.list[0], Catch::Contains("behind its face"));
}

TEST_CASE("initial gaps: an overlap is a warning where the scene accepts it") {
  const Cubes cubes(0.875, "warn");
  const app::OverlapReport report = app::report_overlaps(cubes.input, cubes.mesh, cubes.gaps());
  CHECK(report.faults.empty());
  CHECK(report.warnings.size() == 1);
}

TEST_CASE("initial gaps: a body that overlaps itself is told, where parts meet themselves") {
  const app::InitialGaps gaps = app::initial_gaps(test::bent_bar_scene("self: true"), test::bent_bar(0.1));
  REQUIRE(gaps.overlaps.size() == test::bent_bar_nodes);
  for (const app::InitialOverlap& overlap : gaps.overlaps) {
    CHECK(overlap.is_within_itself());
    CHECK(test::is_bent_bar_depth(overlap.depth, 0.1));
    CHECK_FALSE(overlap.too_deep);
    CHECK(overlap.rule == app::OverlapRule::error);
  }
  CHECK(gaps.piercings.empty());
  CHECK(gaps.smallest == -1);  // a body is at no distance from itself
  CHECK(app::initial_gaps(test::bent_bar_scene("self: false"), test::bent_bar(0.1)).overlaps.empty());
  CHECK(app::initial_gaps(test::bent_bar_scene("self: true"), test::bent_bar(-0.1)).overlaps.empty());
  // an end face of edge 0.5 lets nodes be 0.125 deep
  const app::InitialGaps deep = app::initial_gaps(test::bent_bar_scene("self: true"), test::bent_bar(0.2));
  REQUIRE(deep.overlaps.size() == test::bent_bar_nodes);
  CHECK(deep.overlaps[0].too_deep);
}
