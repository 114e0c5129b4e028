// SPDX-License-Identifier: Apache-2.0
// Messages of refused moves: which nodes, elements and parts they name, and one reason at a time.
#include "app/whole/move_report.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

/// Blocks b and a, while the scene lists part a first; the numbers of nodes and elements are not their positions.
struct RefusedMoves {
  scene::Input input = scene::read_scene(
      "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
      "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
      "parts: {a: {material: m}, b: {material: m}}\ncontact: [{between: all, initial_overlap: move}]\n",
      "test.yaml");
  mesh::Mesh mesh = mesh::box("b", {1, 1, 1}, {1, 1, 1});
  setup::OverlapMoves moves;

  RefusedMoves() {
    mesh::append(mesh, mesh::box("a", {1, 1, 1}, {2, 1, 1}));
    for (GlobalIndex& id : mesh.node_id) id += 100;
    for (mesh::Block& block : mesh.blocks)
      for (GlobalIndex& id : block.element_id) id += 50;
  }
  [[nodiscard]] std::vector<std::string> faults() const {
    return app::report_refused_moves(input, mesh, {"fixed.0", "symmetry.1"}, moves);
  }
};

}  // namespace

TEST_CASE("refused moves: none where the moves succeeded") {
  RefusedMoves refused;
  refused.moves.nodes = 4;
  refused.moves.largest = 0.1;
  CHECK(refused.faults().empty());
}

TEST_CASE("refused moves: constrained nodes are counted by entry, and the first one is named by its number") {
  RefusedMoves refused;
  refused.moves.held = {{.held = 1, .count = 1, .first = 0, .distance = 0.25},
                        {.held = 0, .count = 3, .first = 9, .distance = 1e-3}};
  refused.moves.left = {setup::InitialOverlap{}};  // follows from the same: not told
  const std::vector<std::string> faults = refused.faults();
  REQUIRE(faults.size() == 2);
  CHECK_THAT(faults[0], Catch::StartsWith("test.yaml:6: contact: ") &&
                            Contains("1 node constrained by symmetry.1 (first: node 101, by 0.25)"));
  CHECK_THAT(faults[1], Contains("3 nodes constrained by fixed.0 (first: node 110, by 0.001)"));
}

TEST_CASE("refused moves: a spoiled element has the number of its block and the name of its part") {
  RefusedMoves refused;
  refused.moves.spoiled = setup::SpoiledElement{.block = 1, .element = 1, .kept = 0.04, .wanted = 0.1};
  CHECK_THAT(refused.faults().at(0), Contains("flatten element 53 of part 'a' (a corner keeps 0.04 of its volume, at "
                                              "least 0.1 is required)"));
  refused.moves.spoiled->block = 0;
  refused.moves.spoiled->element = 0;
  refused.moves.spoiled->kept = -0.5;
  CHECK_THAT(refused.faults().at(0), Contains("invert element 51 of part 'b' (a corner keeps -0.5"));
}

TEST_CASE("refused moves: what is left after the last pass, with its deepest node") {
  RefusedMoves refused;
  refused.moves.left = {setup::InitialOverlap{.node = 11, .penetration = 0.125},
                        setup::InitialOverlap{.node = 2, .penetration = 0.1}};
  REQUIRE(refused.faults().size() == 1);
  CHECK_THAT(refused.faults()[0],
             Contains("leaves 2 overlapping nodes after 20 passes (the deepest: node 112, by 0.125)"));
  refused.moves.left.pop_back();
  CHECK_THAT(refused.faults()[0], Contains("leaves 1 overlapping node after 20 passes"));
}
