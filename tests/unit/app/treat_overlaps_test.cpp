// SPDX-License-Identifier: Apache-2.0
// What becomes of overlaps at the start: nodes moved out, overlaps kept as zero gap, bodies that pierce each other, and
// meshes with coincident or shared nodes and flat faces.
#include "app/whole/treat_overlaps.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"
#include "unit/setup/bent_bar.hpp"

using namespace brunt;
using app::TreatedOverlaps;

namespace {

struct Case {
  scene::Input input;
  mesh::CanonicalMesh whole;
  Case(mesh::Mesh mesh, const std::string& rule, const std::string& more = "")
      : input(scene::read_scene("units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
                                "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
                                "parts: {a: {material: m}, b: {material: m}}\n" +
                                    more + "contact: [{between: all, initial_overlap: " + rule + "}]\n",
                                "scene of the test")),
        whole(mesh::canonical_order(std::move(mesh))) {
    scene::select(input, whole);
  }
  TreatedOverlaps treat() { return app::treat_overlaps(input, whole); }
};

mesh::Mesh two_boxes(const Vec3& size_a, std::array<int, 3> elements_a, const Vec3& size_b,
                     std::array<int, 3> elements_b, const Vec3& at_b) {
  mesh::Mesh mesh = mesh::box("a", size_a, elements_a);
  mesh::Mesh other = mesh::box("b", size_b, elements_b);
  mesh::place(other, 1, Vec3(0, 0, 1), 0, at_b);
  mesh::append(mesh, std::move(other));
  return mesh;
}

/// A unit cube of 2^3 elements and a smaller one of 4^3 before the middle of its side; b, the finer, reaches `depth`
/// into a.
mesh::Mesh cubes(double depth) {
  return two_boxes({1, 1, 1}, {2, 2, 2}, {1, 0.8, 0.8}, {4, 4, 4}, {1 - depth, 0.1, 0.1});
}

}  // namespace

TEST_CASE("move: slave nodes go onto the face that they are behind") {
  Case scene(cubes(0.05), "move");
  const std::vector<Vec3> before = scene.whole.mesh.coordinates;
  const TreatedOverlaps treated = scene.treat();
  CHECK(treated.report.faults.empty());
  REQUIRE(treated.report.notes.size() == 1);
  CHECK_THAT(treated.report.notes[0], Catch::Contains("25 nodes moved, by 0.05 at most"));
  CHECK(treated.report.list.size() == 26);
  CHECK(treated.gaps.overlaps.empty());
  CHECK(treated.gaps.smallest == 0);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec3 move = scene.whole.mesh.coordinates[i] - before[i];
    if (move.isZero(0)) continue;
    ++moved;
    CHECK(before[i].x() == Approx(0.95));  // of b's end, not of a's
    CHECK((move - Vec3(0.05, 0, 0)).norm() < 1e-14);
  }
  CHECK(moved == 25);
}

TEST_CASE("move: the other part where the scene names the slave") {
  mesh::Mesh meshes[] = {two_boxes({1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {3, 3, 3}, {0.95, 0, 0}),
                         cubes(0.04)};  // the coarse side is warped around the fine one
  for (mesh::Mesh& mesh : meshes) {
    Case scene(std::move(mesh), "move");
    scene.input.contact[0].between = {"a", "b"};
    scene.input.contact[0].slave = scene::ContactEntry::Slave::first;
    const std::vector<Vec3> before = scene.whole.mesh.coordinates;
    const TreatedOverlaps treated = scene.treat();
    for (const std::string& fault : treated.report.faults) UNSCOPED_INFO(fault);
    CHECK(treated.report.faults.empty());
    CHECK(treated.gaps.overlaps.empty());
    CHECK(scene.whole.mesh.coordinates != before);
    for (std::size_t i = 0; i < before.size(); ++i)
      if (scene.whole.mesh.coordinates[i] != before[i]) CHECK(before[i].x() == 1.0);
  }
}

TEST_CASE("move is refused where nodes are held, elements would be flattened, or nodes are too deep") {
  const auto refusal = [](Case scene) {
    const std::vector<Vec3> before = scene.whole.mesh.coordinates;
    const TreatedOverlaps treated = scene.treat();
    CHECK(scene.whole.mesh.coordinates == before);
    CHECK(treated.report.notes.empty());
    return treated.report.faults.empty() ? "" : treated.report.faults[0];
  };
  CHECK_THAT(refusal({cubes(0.05), "move", "fixed: [{part: b, dofs: [x]}]\n"}),
             Catch::Contains("would displace 25 nodes constrained by fixed.0"));
  CHECK(Case(cubes(0.05), "move", "fixed: [{part: b, dofs: [y, z]}]\n").treat().report.faults.empty());
  // a's faces of 0.5 let nodes be 0.125 deep; b's first elements are 0.13 thick
  CHECK_THAT(refusal({two_boxes({1, 1, 1}, {2, 2, 2}, {0.13, 0.8, 0.8}, {1, 4, 4}, {0.89, 0.1, 0.1}), "move"}),
             Catch::Contains("would flatten element"));
  CHECK_THAT(refusal({cubes(0.2), "move"}), Catch::Contains("too deep for contact to detect"));
}

TEST_CASE("offset: each overlapping node keeps its depth, nothing moves") {
  Case scene(cubes(0.05), "offset");
  const std::vector<Vec3> before = scene.whole.mesh.coordinates;
  const TreatedOverlaps treated = scene.treat();
  CHECK(treated.report.faults.empty());
  CHECK(scene.whole.mesh.coordinates == before);
  REQUIRE(treated.accepted.size() == 26);
  CHECK(std::ranges::is_sorted(treated.accepted, {}, &contact::AcceptedOverlap::slave));
  for (const contact::AcceptedOverlap& overlap : treated.accepted) CHECK(overlap.penetration == Approx(0.05));
}

TEST_CASE("a plate that is pierced without a node inside") {
  // a plate one element thick in z, and a bar of one element through the middle of its faces
  const auto bar_and_plate = [](const Vec3& at) {
    return two_boxes({4, 4, 0.1}, {4, 4, 1}, {0.2, 0.2, 1}, {1, 1, 1}, at);
  };
  for (const std::string rule : {"error", "move", "offset"}) {
    Case scene(bar_and_plate({1.4, 1.4, -0.5}), rule);
    const TreatedOverlaps treated = scene.treat();
    CHECK(treated.gaps.overlaps.empty());
    REQUIRE(treated.gaps.piercings.size() == 1);
    CHECK(treated.gaps.piercings[0].edges == 4);
    REQUIRE(treated.report.faults.size() == 2);
    CHECK_THAT(treated.report.faults[0], Catch::Contains("part 'b' intersects part 'a' (4 edges; first: nodes "));
  }
  CHECK(Case(bar_and_plate({1.4, 1.4, -0.5}), "warn").treat().report.warnings.size() == 1);
  for (const double z : {0.1, -1.0, 0.2})  // standing on it, hanging below it, above it
    CHECK(Case(bar_and_plate({1.4, 1.4, z}), "error").treat().report.list.empty());
  CHECK(Case(bar_and_plate({4, 1.4, -0.5}), "error").treat().report.list.empty());  // beside it, flush with its rim
}

TEST_CASE("a body put where another one is, with every surface node on the other's surface") {
  const auto boxes = [](const Vec3& size, std::array<LocalIndex, 3> elements, const Vec3& at) {
    return two_boxes({1, 1, 1}, {3, 3, 3}, size, elements, at);
  };
  for (const std::string rule : {"error", "move", "offset"}) {
    const TreatedOverlaps treated = Case(boxes({1, 1, 1}, {4, 4, 4}, {0, 0, 0}), rule).treat();
    CHECK(treated.gaps.overlaps.empty());
    REQUIRE(treated.gaps.shared.size() == 1);
    REQUIRE(treated.report.faults.size() == 2);
    CHECK_THAT(treated.report.faults[0],
               Catch::Contains("coincides with part") && Catch::Contains("elements are inside"));
  }
  CHECK(Case(boxes({1, 1, 1}, {3, 3, 3}, {0, 0, 0}), "warn").treat().report.warnings.size() == 1);  // node on node
  CHECK(Case(boxes({1, 1, 1}, {1, 1, 1}, {0, 0, 0}), "error").treat().report.faults.size() == 2);
  CHECK_FALSE(Case(boxes({0.5, 1, 1}, {1, 1, 1}, {0.25, 0, 0}), "error").treat().report.faults.empty());
  CHECK_FALSE(Case(boxes({2, 1, 1}, {1, 1, 1}, {-0.5, 0, 0}), "error").treat().report.faults.empty());
  for (const Vec3& beside : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 1), Vec3(0.5, 0.5, 1)})
    CHECK(Case(boxes({1, 1, 1}, {4, 4, 4}, beside), "error").treat().report.list.empty());
}

TEST_CASE("a node past the middle of a plate is behind the face that it came through, and too deep") {
  Case scene(two_boxes({4, 4, 0.1}, {4, 4, 1}, {0.2, 0.2, 1}, {1, 1, 1}, {1.4, 1.4, 0.02}), "error");
  const TreatedOverlaps treated = scene.treat();
  REQUIRE(treated.gaps.overlaps.size() == 4);
  for (const setup::InitialOverlap& overlap : treated.gaps.overlaps) {
    CHECK(overlap.penetration == Approx(0.08));
    CHECK(overlap.too_deep);
  }
}

TEST_CASE("bars that cross each other with their edges overlap without a node inside") {
  const auto crossed = [](double z) {
    return two_boxes({1, 0.1, 0.1}, {1, 1, 1}, {0.1, 1, 0.1}, {1, 1, 1}, {0.45, -0.45, z});
  };
  CHECK_FALSE(Case(crossed(0.09), "error").treat().gaps.piercings.empty());
  CHECK(Case(crossed(0.1), "error").treat().report.list.empty());
}

TEST_CASE("quarters of balls that touch in a vertex do not pierce each other") {
  // the planes of the quarters coincide but for rounding: edges in them start in the vertex, on both sides of the plane
  for (const auto& [a, b] : {std::pair{5, 5}, {6, 7}, {8, 10}, {10, 12}}) {
    mesh::Mesh mesh = mesh::sphere("a", 0.01, a, {.finer = 8, .half = {true, true, false}});
    mesh::Mesh other = mesh::sphere("b", 0.01, b, {.finer = 7, .half = {true, true, false}});
    mesh::place(mesh, 1, Vec3(0, 0, 1), 0, Vec3(0, 0, 0.01));
    mesh::place(other, 1, Vec3(1, 1, 0), 180, Vec3(0, 0, -0.01));
    mesh::append(mesh, std::move(other));
    const TreatedOverlaps treated = Case(std::move(mesh), "error").treat();
    CAPTURE(a, b);
    CHECK(treated.gaps.piercings.empty());
    CHECK(treated.report.list.empty());
  }
}

TEST_CASE("a body that overlaps itself is refused, warned of, or kept as zero gap; nothing moves it out of itself") {
  const auto treat = [](const std::string& rule) {
    const scene::Input input = scene::read_scene(
        "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
        "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
        "parts: {a: {material: m}}\ncontact: [{between: all, initial_overlap: " +
            rule + "}]\n",
        "scene of the test");
    mesh::CanonicalMesh whole = mesh::canonical_order(test::bent_bar(0.1));
    scene::select(input, whole);
    const std::vector<Vec3> before = whole.mesh.coordinates;
    TreatedOverlaps treated = app::treat_overlaps(input, whole);
    CHECK(whole.mesh.coordinates == before);
    CHECK(treated.report.list.size() == test::bent_bar_nodes);
    return treated;
  };
  TreatedOverlaps treated = treat("error");
  REQUIRE(treated.report.faults.size() == 2);
  CHECK_THAT(treated.report.faults[0], Catch::Contains("inside part 'a' (one body, which overlaps itself)"));
  treated = treat("warn");
  CHECK(treated.report.faults.empty());
  CHECK(treated.report.warnings.size() == 1);
  CHECK(treated.recovered);
  treated = treat("move");
  REQUIRE(treated.report.faults.size() == 2);
  CHECK_THAT(treated.report.faults[1], Catch::Contains("move does not separate a body from itself"));
  treated = treat("offset");
  CHECK(treated.report.faults.empty());
  REQUIRE(treated.accepted.size() == test::bent_bar_nodes);
  for (const contact::AcceptedOverlap& overlap : treated.accepted) {
    CHECK(overlap.body == 0);
    CHECK(test::is_bent_bar_depth(overlap.penetration, 0.1));
  }
}

TEST_CASE("flush bodies that overlap do so with the nodes on their sides as well") {
  // b's end of 3 x 3 nodes in a's, its sides on a's sides; and a's in b's
  Case scene(two_boxes({1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {2, 2, 2}, {0.95, 0, 0}), "offset");
  const TreatedOverlaps treated = scene.treat();
  REQUIRE(treated.accepted.size() == 18);
  for (const contact::AcceptedOverlap& overlap : treated.accepted) CHECK(overlap.penetration == Approx(0.05));
  CHECK(Case(two_boxes({1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {2, 2, 2}, {1, 0, 0}), "error").treat().report.list.empty());
}

TEST_CASE("E17, E18: shared and coincident nodes, flat faces and elements: no overlap, no crash") {
  // b's nodes on a's, not joined
  const auto touching = [] { return two_boxes({1, 1, 1}, {2, 2, 2}, {1, 1, 1}, {2, 2, 2}, {1, 0, 0}); };
  for (const std::string rule : {"error", "move", "offset"}) {
    const TreatedOverlaps treated = Case(touching(), rule).treat();
    CHECK(treated.report.list.empty());
    CHECK(treated.accepted.empty());
    CHECK(treated.gaps.smallest == 0);
  }
  SECTION("two parts share one node only") {
    mesh::Mesh mesh = two_boxes({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    const auto corner = [&](std::size_t block, const Vec3& at) -> LocalIndex& {
      return *std::ranges::find_if(mesh.blocks[block].nodes,
                                   [&](LocalIndex n) { return mesh.coordinates[static_cast<std::size_t>(n)] == at; });
    };
    corner(1, Vec3(1, 1, 1)) = corner(0, Vec3(1, 1, 1));
    CHECK(Case(std::move(mesh), "error").treat().report.list.empty());  // one body
  }
  SECTION("a face drawn to a line, and one without area") {
    mesh::Mesh mesh = cubes(0.05);
    const LocalIndex* nodes = mesh.blocks[1].element(0);
    const auto at = [&](int c) -> Vec3& { return mesh.coordinates[static_cast<std::size_t>(nodes[c])]; };
    at(3) = at(0);  // the end face's corner falls on the next
    at(7) = at(4) = at(0);
    CHECK_NOTHROW(Case(mesh, "warn").treat());
    CHECK_NOTHROW(Case(mesh, "offset").treat());
    CHECK_NOTHROW(Case(mesh, "move").treat());
  }
}
