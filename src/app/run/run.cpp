// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/program/commands.hpp"
#include "app/program/failure.hpp"
#include "app/program/signals.hpp"
#include "app/report/results.hpp"
#include "app/start/prepare.hpp"
#include "app/start/restart.hpp"
#include "app/state/removal.hpp"
#include "core/error.hpp"
#include "implicit/solver.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/result_folder.hpp"
#include "io/results/summary.hpp"
#include "io/text_file.hpp"
#include "run_loop.hpp"
#include "schedule.hpp"

namespace brunt::app {
namespace {

/// A run continues in the folder of its checkpoint; another folder contains results of another run.
io::ExistingResults existing_results(const RunOptions& options, const std::string& checkpoint,
                                     const std::string& folder) {
  std::error_code no_folder;
  const std::filesystem::path from = std::filesystem::path(checkpoint).parent_path();
  const bool its_own = !checkpoint.empty() && std::filesystem::equivalent(from.empty() ? "." : from, folder, no_folder);
  if (its_own) return io::ExistingResults::keep;  // also by force: the checkpoint is one of the results
  return options.force ? io::ExistingResults::replace : io::ExistingResults::refuse;
}

/// Whether the summary of the folder describes this state.
bool is_reported(const comm::Communicator& ranks, const std::string& folder, GlobalIndex step) {
  return ranks.any(ranks.is_root() && io::summarised_steps(folder) == step);
}

/// Records what this start has read.
void record_scene(const Prepared& run, const RunOptions& options, const std::string& folder) {
  io::replace_text(folder + "/scene_as_run.yaml",
                   fmt::format("# {} as read by {}, with its overrides; paths of files are relative to that scene\n{}",
                               std::filesystem::path(options.scene).filename().string(), version(), run.scene_yaml));
}

/// Explicit runs evaluate the step of the checkpoint again, and write its records again. Implicit runs do not; a record
/// that is not due there was written at the end of the run.
KeptRecords kept_records(const Prepared& run) {
  const model::State& state = run.state;
  const auto step = static_cast<GlobalIndex>(state.step);
  const bool fields = run.implicit && due(state, run.input.output.every, implicit_slack);
  const bool row = run.implicit && implicit_row_due(state, run.input);
  return {fields ? step : step - 1, row ? step : step - 1};
}

/// A restart keeps the step of an implicit run where this scene alone would have another one.
std::string kept_step(const Prepared& run) {
  if (!run.implicit || run.implicit->settings.step == run.input.implicit->step) return {};
  return fmt::format(", with the step {:g} of its beginning", run.implicit->settings.step);
}

void announce(const Prepared& run, Log& log) {
  const model::Model& model = run.model;
  log.line(fmt::format("{} ({} units)", run.input.title.empty() ? run.input.file : run.input.title, run.input.units));
  log.line(fmt::format("{} elements, {} nodes, {} parts{}, {} rank{}", model.mesh.global_elements,
                       model.mesh.global_nodes, model.blocks.size(),
                       model.bodies.empty() ? "" : fmt::format(" ({} rigid)", model.bodies.size()),
                       run.links.ranks.size(), run.links.ranks.size() == 1 ? "" : "s"));
}

void report_iterations(const Prepared& run, Log& log) {
  report_erosion(run, log);
  if (!run.contact) return;
  const contact::ContactStatistics& contact = run.contact->ledger.statistics;
  if (contact.steps_at_limit > 0)
    log.line(
        fmt::format("contact: {} of {} steps with contact ended at max_iterations {}, with residuals of at most {:.2g}",
                    contact.steps_at_limit, contact.solved_steps, run.model.touching.contact.enforcement.max_iterations,
                    contact.largest_residual));
}

}  // namespace

int run(const comm::Communicator& ranks, const RunOptions& options) {
  const Clock::time_point start = Clock::now();
  const std::string folder =
      options.out.empty() ? std::filesystem::path(options.scene).replace_extension(".out").string() : options.out;
  const io::StopRequest earlier = ranks.is_root() ? io::stop_request(folder) : io::StopRequest{};
  Log log(ranks.is_root(), options.quiet);
  const std::unique_ptr<Prepared> prepared = prepare(ranks, options.scene, options.overrides, options.partition);
  refuse_overlaps(*prepared);
  demand_first_step(*prepared);
  const std::string checkpoint = options.restart.empty() ? "" : checkpoint_of(ranks, options.restart);

  std::optional<io::CheckpointHeader> restart;
  if (!checkpoint.empty()) restart = restart_from(*prepared, checkpoint);
  const io::ExistingResults existing = existing_results(options, checkpoint, folder);
  const bool was_asked_to_stop = io::prepare_result_folder(ranks, folder, existing, earlier);
  on_root(ranks, [&] { log.open(folder, restart.has_value()); });
  announce(*prepared, log);
  for (const std::string& line : prepared->left_out) log.line(line);
  for (const std::string& warning : prepared->warnings) log.warning(warning);
  for (const std::string& note : prepared->overlaps.report.notes) log.line(note);
  if (was_asked_to_stop) log.line(fmt::format("removed {}/{}, which is older than this run", folder, io::stop_file));
  if (restart) log.line(fmt::format("restart from {} at step {}{}", checkpoint, restart->step, kept_step(*prepared)));
  const bool over = restart && at_end(prepared->state, prepared->input.run);
  if (over) {
    const std::optional<GlobalIndex>& steps = prepared->input.run.steps;
    log.warning(fmt::format(
        "nothing to run: the checkpoint is at t = {:g}, step {}, the end of this run; a {} continues from there",
        prepared->state.time, restart->step, steps && restart->step >= *steps ? "larger run.steps" : "later run.end"));
  }
  if (over && existing == io::ExistingResults::keep && is_reported(ranks, folder, restart->step)) {
    log.line("the results in " + folder + " remain unchanged");
    return static_cast<int>(ExitCode::done);
  }
  on_root(ranks, [&] { record_scene(*prepared, options, folder); });
  catch_signals();
  Results results(*prepared, folder, restart ? std::optional(kept_records(*prepared)) : std::nullopt, log);
  if (restart) results.warn_of_missing_rows(*restart);
  release_freed_memory();
  prepared->start_up.end(StartStage::opening);
  Loop loop(*prepared, results, log, start);
  Outcome outcome = loop.go();
  if (!outcome.message.empty()) log.fault("stopped: " + outcome.message);
  if (const double past = overshoot(prepared->state, prepared->input.run); past > 0.01 && !over)
    log.warning(fmt::format(
        "the run ended at t = {:g}, {:.2g} % after its end: steps are never shortened, and this run has few",
        prepared->state.time, 100 * past));
  report_iterations(*prepared, log);
  if (outcome.code != ExitCode::guard) results.write_checkpoint();
  results.seal();
  if (outcome.code == ExitCode::guard) {
    results.read_fields();  // the motion at the last step that was right
    results.write_fields(nullptr);
  } else {
    loop.last_record(outcome);
    if (outcome.code == ExitCode::guard) log.fault("stopped: " + outcome.message);
  }
  if (outcome.code == ExitCode::guard)
    if (const std::string saved = results.save_last_good(); !saved.empty()) log.line("last good state: " + saved);
  results.report_at_end();
  const int code = static_cast<int>(outcome.code);
  results.write_summary(outcome.stopped_by, code, seconds_since(start), loop.cost());
  log.line(fmt::format("{}; results in {}",
                       outcome.code == ExitCode::done    ? "done"
                       : outcome.code == ExitCode::guard ? "stopped by a guard"
                                                         : "stopped on request, checkpoint written",
                       folder));
  return code;
}

}  // namespace brunt::app
