// SPDX-License-Identifier: Apache-2.0
// Penetration by positions: what is told once, what ends a run, and what is none of the watch's business.
#include "app/watch/depth_watch.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "prepared_scene.hpp"

using namespace brunt;

namespace {

/// A block of 6 x 6 x 4 unit elements, its top at z = 4, and a cube of one element over it, clear of the block's nodes.
struct WatchedDepth {
  support::PreparedScene scene;
  app::DepthWatch watch;

  explicit WatchedDepth(const std::string& contact, const std::string& x = "2.1", double over = 0)
      : scene(
            "units: mm-ms-g\nmesh:\n"
            "  - {box: {part: low, size: [6, 6, 4], elements: [6, 6, 4]}}\n"
            "  - {box: {part: top, size: [0.8, 0.8, 0.8], elements: [1, 1, 1], at: [" +
            x + ", 2.1, " + std::to_string(4 + over) +
            "]}}\n"
            "materials: {m: {model: elastic, density: 1, young: 100, poisson: 0}}\n"
            "parts: {low: {material: m}, top: {material: m}}\nrun: {end: 1}\n" +
            contact) {}
  void lower(double by) {
    const app::Prepared& run = *scene.run;
    for (int corner = 0; corner < 8; ++corner)
      scene.run->state.nodes[static_cast<std::size_t>(run.model.blocks[1].corner_node(0, corner))].x[2] -= by;
  }
  std::vector<std::string> look() { return watch.look(*scene.run); }
};

const std::string contact_of_all = "contact: [{between: all}]\n";

}  // namespace

TEST_CASE("depth watch: the depth below the face, told once for a pair, and the deepest so far") {
  WatchedDepth run(contact_of_all);
  CHECK(run.look().empty());
  CHECK(run.watch.deepest().share < 1e-12);
  run.lower(0.05);
  CHECK(run.look().empty());
  CHECK(run.watch.deepest().share == Approx(0.05));
  run.lower(0.25);
  const std::vector<std::string> first = run.look();
  REQUIRE(first.size() == 1);
  CHECK_THAT(first[0], Catch::Contains("of part 'top' lies 0.3 mm deep in part 'low' at t = 0, step 0, 0.3 of an "
                                       "element there") &&
                           Catch::Contains("nodes and edges are deeper than 0.1"));
  run.lower(0.2);
  CHECK(run.look().empty());
  CHECK(run.watch.deepest().depth == Approx(0.5));
  run.lower(-0.4);
  CHECK(run.look().empty());
  CHECK(run.watch.deepest().depth == Approx(0.5));
}

TEST_CASE("depth watch: a node deeper than an element ends the run, also of a pair that was told") {
  WatchedDepth run(contact_of_all);
  run.lower(0.99);
  CHECK(run.look().size() == 1);
  run.lower(0.02);
  CHECK_THROWS_AS(run.look(), GuardError);
  CHECK(run.watch.deepest().share == Approx(1.01));
}

TEST_CASE("depth watch: bodies that begin inside each other are told, but do not end the run") {
  WatchedDepth run("contact: [{between: all, initial_overlap: offset}]\n", "2.1", -0.15);
  run.lower(1.2);
  CHECK(run.look().size() == 1);
  CHECK(run.watch.deepest().share == Approx(1.35));
}

TEST_CASE("depth watch: parts without contact with each other, bodies apart, and scenes without contact") {
  WatchedDepth apart("contact: [{between: all, exclude: [[top, low]]}]\n");
  apart.lower(1.5);
  CHECK(apart.look().empty());
  WatchedDepth beside(contact_of_all, "7.1");
  beside.lower(1.5);
  CHECK(beside.look().empty());
  WatchedDepth none("");
  none.lower(1.5);
  CHECK(none.look().empty());
  CHECK_FALSE(none.watch.is_due(*none.scene.run));
}

TEST_CASE("depth watch: a removed element holds no node inside, and is due after three lists") {
  WatchedDepth run(contact_of_all);
  run.lower(0.3);
  model::State& state = run.scene.run->state;
  state.alive = {std::vector<double>(144, 0.0), {}};
  CHECK(run.look().empty());
  GlobalIndex& searches = run.scene.run->contact->ledger.statistics.searches;
  CHECK_FALSE(run.watch.is_due(*run.scene.run));
  searches += 2;
  CHECK_FALSE(run.watch.is_due(*run.scene.run));
  searches += 1;
  CHECK(run.watch.is_due(*run.scene.run));
  (void)run.look();
  CHECK_FALSE(run.watch.is_due(*run.scene.run));
}
