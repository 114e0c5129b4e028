// SPDX-License-Identifier: Apache-2.0
// What is said of overlaps: names of the input, one line a pair, advice that fits what can be done.
#include "app/whole/overlap_report.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using app::OverlapReport;
using Catch::Contains;
using setup::InitialGaps;
using setup::InitialOverlap;
using setup::OverlapRule;

namespace {

/// Two cubes of one element each: nodes 1 to 8 and 9 to 16, blocks 0 and 1.
struct Parts {
  scene::Input input = scene::read_scene(
      "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
      "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
      "parts: {anvil: {block: a, material: m}, hammer: {block: b, material: m}}\n"
      "contact: [{between: all}]\n",
      "forge.yaml");
  mesh::Mesh mesh;
  Parts() {
    mesh::append(mesh, mesh::box("a", Vec3(1, 1, 1), {1, 1, 1}), "");
    mesh::append(mesh, mesh::box("b", Vec3(1, 1, 1), {1, 1, 1}), "");
    for (std::size_t n = 0; n < mesh.node_id.size(); ++n) mesh.node_id[n] = 100 + static_cast<GlobalIndex>(n);
  }
  [[nodiscard]] OverlapReport report(std::vector<InitialOverlap> overlaps,
                                     std::vector<setup::Piercing> piercings = {}) const {
    InitialGaps gaps;
    gaps.overlaps = std::move(overlaps);
    gaps.piercings = std::move(piercings);
    return app::report_overlaps(input, mesh, gaps);
  }
};

/// A node of the hammer in the anvil, behind its upper face.
InitialOverlap in_anvil(LocalIndex node, double depth, OverlapRule rule = OverlapRule::error) {
  InitialOverlap overlap{.node = node, .block = 1, .other_block = 0, .body = 1, .other_body = 0, .penetration = depth};
  overlap.face = {4, 5, 7, 6};
  overlap.rule = rule;
  return overlap;
}

}  // namespace

TEST_CASE("overlap report: nothing to say of parts that do not overlap") {
  const OverlapReport report = Parts().report({});
  CHECK(report.list.empty());
  CHECK(report.faults.empty());
  CHECK(report.warnings.empty());
}

TEST_CASE("overlap report: nodes and faces have the input's numbers; both ways between two parts are one pair") {
  InitialOverlap back = in_anvil(7, 0.1);
  std::swap(back.block, back.other_block);
  std::swap(back.body, back.other_body);
  const OverlapReport report = Parts().report({in_anvil(8, 0.25), in_anvil(9, 0.125), back});
  REQUIRE(report.list.size() == 3);
  CHECK_THAT(report.list[0], Contains("108") && Contains("of hammer") && Contains("0.25 inside anvil") &&
                                 Contains("behind its face 104-105-107-106") && Contains(", at ["));
  CHECK_THAT(report.list[2], Contains("107") && Contains("of anvil") && Contains("inside hammer"));
  REQUIRE(report.faults.size() == 2);
  CHECK_THAT(
      report.faults[0],
      Contains("forge.yaml:6: contact.0: initial overlap: node 108 of part 'hammer' lies 0.25 inside part 'anvil'") &&
          Contains("the deepest of 3 overlapping nodes of the two parts") && Contains("; node 108 is at ["));
  CHECK_THAT(report.faults[1], Contains("warn") && Contains("move") && Contains("offset"));
}

TEST_CASE("overlap report: of many nodes the ten deepest of each pair are listed, and how many more there are") {
  std::vector<InitialOverlap> overlaps;
  for (int k = 0; k < 8; ++k) overlaps.push_back(in_anvil(8 + k, 0.5 - 0.01 * k));
  for (int k = 0; k < 4; ++k) {
    overlaps.push_back(in_anvil(k, 0.3 - 0.01 * k));
    std::swap(overlaps.back().block, overlaps.back().other_block);
  }
  for (int k = 0; k < 2; ++k) {
    overlaps.push_back(in_anvil(8 + k, 0.1));
    overlaps.back().other_block = 1;  // a pair of its own
  }
  const OverlapReport report = Parts().report(overlaps);
  CHECK(report.list.size() == 14);
  REQUIRE(report.deepest.size() == 13);
  for (std::size_t k = 0; k < 10; ++k) CHECK(report.deepest[k] == report.list[k]);
  CHECK(report.deepest[10] == report.list[12]);
  CHECK_THAT(report.deepest[12], Contains("2 more nodes of anvil and hammer") && Contains("--all"));
}

TEST_CASE("overlap report: one node is not called the deepest of one") {
  const OverlapReport report = Parts().report({in_anvil(8, 0.25, OverlapRule::warn)});
  REQUIRE(report.warnings.size() == 1);
  CHECK_THAT(report.warnings[0], !Contains("deepest"));
  CHECK(report.faults.empty());
}

TEST_CASE("overlap report: what move and offset treat is not told; what they cannot is a fault of its own") {
  for (const OverlapRule rule : {OverlapRule::move, OverlapRule::offset}) {
    InitialOverlap deep = in_anvil(9, 0.5, rule);
    CHECK(Parts().report({in_anvil(8, 0.1, rule)}).faults.empty());
    deep.too_deep = true;
    const OverlapReport report = Parts().report({deep, in_anvil(8, 0.1, rule)});
    REQUIRE(report.faults.size() == 2);
    CHECK_THAT(report.faults[0], Contains("1 of them are too deep"));
    CHECK_THAT(report.faults[1], Contains("expected parts farther apart") && !Contains("recovered slowly"));
    CHECK_THAT(report.faults[1], !Contains(rule == OverlapRule::move ? "offset" : "move"));
  }
}

TEST_CASE("overlap report: without a rule of the scene no rule is named as used") {
  InitialOverlap deep = in_anvil(9, 0.5, OverlapRule::error);
  deep.too_deep = true;
  const OverlapReport report = Parts().report({deep, in_anvil(8, 0.1, OverlapRule::error)});
  REQUIRE(report.faults.size() == 2);
  CHECK_THAT(report.faults[1], Contains("expected parts that do not overlap, or initial_overlap: place"));
  CHECK_THAT(report.faults[1],
             !Contains("initial_overlap: move") && !Contains("offset") && !Contains("invalid initial_overlap:"));
}

TEST_CASE("overlap report: a body in itself can be offset but not moved; piercings never are") {
  InitialOverlap fold = in_anvil(8, 0.1, OverlapRule::move);
  fold.body = fold.other_body;
  const OverlapReport moved = Parts().report({fold});
  REQUIRE(moved.faults.size() == 2);
  CHECK_THAT(moved.faults[0], Contains("one body, which overlaps itself"));
  CHECK_THAT(moved.faults[1], Contains("move does not separate a body from itself"));
  fold.rule = OverlapRule::offset;
  CHECK(Parts().report({fold}).faults.empty());
  const setup::Piercing piercing{.block = 1,
                                 .other_block = 0,
                                 .edges = 2,
                                 .edge = {8, 12},
                                 .face = {0, 1, 2, no_index},
                                 .rule = OverlapRule::offset};
  const OverlapReport pierced = Parts().report({}, {piercing});
  REQUIRE(pierced.faults.size() == 2);
  CHECK_THAT(pierced.faults[0],
             Contains("'hammer' intersects part 'anvil' (2 edges; first: nodes 108-112 through face 100-101-102)"));
}
