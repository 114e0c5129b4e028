// SPDX-License-Identifier: Apache-2.0
// The files of a run, and the guard that watches the energy.
#include "app/report/results.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/start/restart.hpp"
#include "core/error.hpp"
#include "prepared_scene.hpp"

using namespace brunt;
using app::Extremes;

namespace {

struct Written {
  support::PreparedScene scene{support::two_bodies +
                               "contact: [{between: all, passes: one}]\noutput: {every: 1, fields: [velocity]}\n"};
  app::Log log{false, true};
  app::Results results{*scene.run, scene.folder.path.string(), std::nullopt, log};

  [[nodiscard]] std::string text(const std::string& name) const {
    std::stringstream all;
    all << std::ifstream(scene.folder.file(name)).rdbuf();
    return all.str();
  }
  time::Ledger step() {
    scene.evaluate();
    results.read_fields();
    results.read_probes();
    scene.advance();
    return time::ledger(scene.run->model, scene.run->state, scene.run->scratch, scene.run->links,
                        scene.run->contact.get(), scene.report);
  }
};

}  // namespace

TEST_CASE("results: a row of history, a record of fields, a summary") {
  Written run;
  const time::Ledger ledger = run.step();
  run.results.write_fields(&run.scene.report);
  run.results.write_history(ledger, run.scene.report, {0, 0.0});
  run.results.watch(ledger, 0);
  run.results.seal();
  run.results.write_summary("steps", 0, 1.5, {1.0, 1, {}});

  std::stringstream history(run.text("history.csv"));
  std::string header, row;
  std::getline(history, header);
  std::getline(history, row);
  CHECK_THAT(header, Catch::StartsWith("step,time"));
  CHECK(std::ranges::count(header, ',') == std::ranges::count(row, ','));
  CHECK_THAT(row, Catch::StartsWith("0,0"));
  CHECK(std::filesystem::exists(run.scene.folder.file("state.h5")));
  const nlohmann::json summary = nlohmann::json::parse(run.text("summary.json"));
  CHECK(summary["steps"] == 1);
  CHECK(summary["elements"] == 5);
  CHECK(summary["nodes"] == 26);
  CHECK(summary["stopped_by"] == "steps");
  CHECK(summary["contact"]["searches"] == 1);
  CHECK(summary["contact"]["active"] == 4);
  CHECK(summary["energy"]["contact"] > 0);
  CHECK(summary["energy"]["total"].get<double>() == Approx(0.5 * 3 * 5));
}

TEST_CASE("results: kinetic energy from nowhere stops the run, what an external force has given does not") {
  Written run;
  time::Ledger ledger;
  ledger.kinetic = 10;
  CHECK_NOTHROW(run.results.watch(ledger, 0));
  CHECK(run.results.extremes().start_total == 10);
  ledger.kinetic = 10.4;
  CHECK_NOTHROW(run.results.watch(ledger, 1));  // a warning
  CHECK(run.log.warnings() == 1);
  CHECK_NOTHROW(run.results.watch(ledger, 1));  // told once
  CHECK(run.log.warnings() == 1);
  CHECK(error_ratio(run.results.extremes()) == Approx(0.4 / 10.4));
  ledger.kinetic = 40;
  CHECK_THROWS_AS(run.results.watch(ledger, 2), GuardError);
  ledger.external = 30;
  CHECK_NOTHROW(run.results.watch(ledger, 3));
  ledger.kinetic = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(run.results.watch(ledger, 4), GuardError);
}

TEST_CASE("results: a restart judges by what the whole run has seen") {
  Written run;
  time::Ledger ledger = run.step();
  run.results.watch(ledger, 0);
  const Extremes seen = run.scene.run->extremes;
  CHECK(seen.start_total == Approx(7.5));
  const std::string file = run.results.write_checkpoint();
  Written again;
  app::restart_from(*again.scene.run, file);
  CHECK(again.scene.run->extremes.start_total == seen.start_total);
  CHECK(again.scene.run->extremes.largest_energy == seen.largest_energy);
  CHECK(again.scene.run->extremes.momentum_scale == seen.momentum_scale);
  ledger.kinetic = 0.5 * seen.start_total;  // the other half is gone
  ledger.internal = ledger.hourglass = ledger.bulk = ledger.contact = ledger.friction = 0;
  CHECK_THROWS_AS(again.results.watch(ledger, 1), GuardError);
}

TEST_CASE("results: the guard names the element with the least hourglass energy") {
  Written run;
  time::Ledger ledger = run.step();
  run.results.watch(ledger, 0);
  const model::ElementBlock& block = run.scene.run->model.blocks[0];
  LocalIndex element = 0;
  while (block.input[static_cast<std::size_t>(element)] != 2) ++element;
  const std::ptrdiff_t row =
      std::ptrdiff_t{element / pack_width} * block.history_size + block.find("hourglass_energy")->first;
  run.scene.run->state.history[0][static_cast<std::size_t>(row * pack_width + element % pack_width)] = -3;
  ledger.hourglass = -3;
  ledger.internal += 3;
  CHECK_THROWS_WITH(run.results.watch(ledger, 1),
                    Catch::Contains("element 3 (position in the input) of part 'low' at (0.5, 1.5, 0.47") &&
                        Catch::Contains("must not be negative") && Catch::Contains("hex8_full"));
}

TEST_CASE("results: after a guard the last good state comes back, as a checkpoint and in the run") {
  Written run;
  CHECK(run.results.save_last_good().empty());  // nothing remembered
  run.step();
  run.results.remember_good();
  const double good = run.scene.run->state.nodes[0].v[2];
  run.step();
  run.scene.run->state.nodes[0].v[2] = 1e9;
  const std::string file = run.results.save_last_good();
  CHECK(std::filesystem::exists(file));
  CHECK(run.scene.run->state.nodes[0].v[2] == good);
  CHECK(run.scene.run->state.step == 1);
}
