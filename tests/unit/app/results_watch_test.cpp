// SPDX-License-Identifier: Apache-2.0
// What a run tells of folded elements, once, and what it tells at its end of made-up ledgers.
#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "app/report/results.hpp"
#include "prepared_scene.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

struct ToldResults {
  support::PreparedScene scene;
  app::Log log{true, true};
  app::Results results;

  explicit ToldResults(const std::string& text = support::two_bodies + "contact: [{between: all, passes: one}]\n")
      : scene(text), results(*scene.run, scene.folder.path.string(), std::nullopt, log) {
    log.open(scene.folder.path.string(), false);
  }
  /// log.txt so far.
  [[nodiscard]] std::string told() const {
    std::stringstream all;
    all << std::ifstream(scene.folder.file("log.txt")).rdbuf();
    return all.str();
  }
  /// Moves a node of an element along x.
  void pull(std::size_t block, int corner, double by) {
    const LocalIndex node = scene.run->model.blocks[block].corner_node(0, corner);
    scene.run->state.nodes[static_cast<std::size_t>(node)].x[0] += by;
  }
  /// The log of a run that begins with the kinetic energy 10 and the momentum 4, and ends like this.
  [[nodiscard]] std::string at_end(time::Ledger ledger) {
    time::Ledger start;
    start.kinetic = 10;
    start.momentum_scale = ledger.momentum_scale = 4;
    results.watch(start, 0);
    results.watch(ledger, 1);
    results.report_at_end();
    return told();
  }
};

}  // namespace

TEST_CASE("results watch: folded elements are counted and named once, with a remedy for their material") {
  const auto [kind, material, remedy] = GENERATE(table<const char*, const char*, const char*>(
      {{"hex8", "model: elastic, density: 3, young: 100, poisson: 0", "Use element: hex8_full or hex8_bbar ("},
       {"hex8", "model: neo_hookean, density: 3, bulk: 100, shear: 50", "Use element: hex8_full ("},
       {"hex8_full", "model: elastic, density: 3, young: 100, poisson: 0", "Use smaller elements there ("}}));
  std::string text = support::two_bodies;
  const auto replace = [&](const std::string& what, const std::string& by) {
    text.replace(text.find(what), what.size(), by);
  };
  replace("model: elastic, density: 3, young: 100, poisson: 0", material);
  replace("top: {material: m}", std::string("top: {material: m, element: ") + kind + "}");
  ToldResults run(text);
  run.results.watch_folds();
  CHECK(run.log.warnings() == 0);
  run.pull(1, 1, -1.2);  // beyond the corner beside it
  run.results.watch_folds();
  CHECK(run.log.warnings() == 1);
  CHECK_THAT(run.told(), Contains(std::string(kind) + " element is folded at t = 0, step 0") &&
                             Contains("the worst is element 5 (position in the input) of part 'top'") &&
                             Contains(remedy));
  run.pull(0, 1, -1.5);
  run.results.watch_folds();
  CHECK(run.log.warnings() == 1);
}

TEST_CASE("results watch: hourglass energy above a tenth of the internal one, unless both are nothing") {
  for (const auto& [hourglass, internal, warned] :
       {std::tuple(0.2, 1.8, true), std::tuple(0.1, 1.9, false), std::tuple(0.005, 0.01, false)}) {
    ToldResults run;
    time::Ledger ledger;
    ledger.hourglass = hourglass;
    ledger.internal = internal;
    ledger.kinetic = 10 - hourglass - internal;
    const std::string told = run.at_end(ledger);
    CHECK(run.log.warnings() == (warned ? 1 : 0));
    if (warned) CHECK_THAT(told, Contains("hourglass energy is 11 % of the largest internal energy"));
  }
}

TEST_CASE("results watch: what contact has taken of bodies that have separated, and only of those") {
  for (const auto& [taken, touching, warned] :
       {std::tuple(0.5, 0, true), std::tuple(0.5, 1, false), std::tuple(0.2, 0, false)}) {
    ToldResults run;
    time::Ledger ledger;
    ledger.contact = ledger.contact_totals.contact_work = taken;
    ledger.kinetic = 10 - taken;
    ledger.contact_totals.push = 1;
    ledger.contact_totals.touching = touching;
    const std::string told = run.at_end(ledger);
    CHECK(run.log.warnings() == (warned ? 1 : 0));
    if (warned) CHECK_THAT(told, Contains("contact dissipated 5 % of the largest energy"));
  }
}

TEST_CASE("results watch: angular momentum from contact, over the momentum and half of the diagonal") {
  for (const double spin : {0.05, 0.005}) {  // of 4 sqrt(3): the bodies fill a cube of 2
    ToldResults run;
    time::Ledger ledger;
    ledger.kinetic = 10;
    ledger.contact_totals.spin = spin * Vec3(0, 0.6, -0.8);
    const std::string told = run.at_end(ledger);
    CHECK(run.log.warnings() == (spin > 0.01 ? 1 : 0));
    if (spin > 0.01) CHECK_THAT(told, Contains("angular_momentum_error is 0.0072, 0.001 at most is usual"));
  }
}
