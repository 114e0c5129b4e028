// SPDX-License-Identifier: Apache-2.0
#include "run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <variant>

#include "brunt/core/error.hpp"
#include "brunt/io/checkpoint.hpp"
#include "brunt/io/result_folder.hpp"
#include "brunt/io/summary.hpp"
#include "brunt/io/text_file.hpp"
#include "brunt/time/initialise.hpp"
#include "brunt/time/ledger.hpp"
#include "brunt/time/relaxation.hpp"
#include "brunt/time/step.hpp"
#include "commands.hpp"
#include "contact_setup.hpp"
#include "element_place.hpp"
#include "failure.hpp"
#include "prepare.hpp"
#include "restart.hpp"
#include "results.hpp"
#include "schedule.hpp"
#include "signals.hpp"

namespace brunt::app {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr int steps_between_watches = 200;  // the ledger costs a pass over all nodes, a look at folds one of elements
constexpr int table_lines = 20;             // about so many over a run

/// An element keeps its step for as long as its edges and its volume keep their size.
const char* cause_of_collapse(const ElementPlace& place) {
  constexpr double much = 0.1;
  if (place.shortest_edge < much || place.volume < much)
    return "it is pressed flat, by a sharp or much smaller body or under a load that its law cannot carry; take "
           "smaller "
           "elements there, or a law that hardens under pressure";
  return "it is folded or sheared so far that a wave crosses it in no time, or its law stiffens with its strain";
}

/// B-bar averages the change of volume over the element: a corner's own volume meets the deviatoric stress alone, which
/// plastic flow bounds, so that little work turns the corner inside out.
const char* cause_of_lost_volume(const model::ElementBlock& block) {
  if (block.kind != element::ElementKind::hex8_bbar || !std::holds_alternative<material::J2>(block.law)) return "";
  return ". Likely cause: a sharp load on a corner of hex8_bbar, which holds an element's mean volume alone and yields "
         "in all else; take element: hex8_full, or hex8 with hourglass: {kind: elastic}, for bodies that strike "
         "others by edges and corners";
}

/// Why the loop ended.
struct Outcome {
  std::string stopped_by = "end";
  ExitCode code = ExitCode::done;
  std::string message;
};

std::string not_at_rest(const model::Relaxation& phase, const scene::Relaxation& asked) {
  return fmt::format(
      "relaxation: not at rest after {} steps (max_steps): {:.0f} % of the loads, unbalanced forces {:.2g} of them, "
      "tolerance {:g}; bodies that nothing supports never come to rest",
      asked.max_steps, 100 * phase.stage / time::relaxation_stages, phase.residual, asked.tolerance);
}

/// Of all nodes [length]. Collective.
double largest_displacement(const Prepared& run) {
  double largest = 0;
  for (const Quad& u : run.state.displacement) largest = std::max(largest, u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  return std::sqrt(run.links.ranks.max(largest));
}

class Loop {
 public:
  Loop(Prepared& run, Results& results, Log& log, Clock::time_point program_start)
      : run_(run), results_(results), log_(log), program_start_(program_start) {}

  Outcome go() {
    Outcome outcome;
    try {
      if (!relaxing() || come_to_rest(outcome)) go_on(outcome);
    } catch (const GuardError& error) {
      outcome = {"guard", ExitCode::guard, error.what()};
    }
    cost_ = {seconds_since(loop_start_), passes_, run_.links.timers};
    return outcome;
  }

  /// Evaluates t_N once more for its fields and its ledger; the step that this takes is not part of the run. A guard
  /// may find there what it has not seen before.
  void last_record(Outcome& outcome) {
    try {
      if (!relaxing()) pass(true);  // before t = 0 there is nothing to tell
    } catch (const GuardError& error) {
      outcome = {"guard", ExitCode::guard, error.what()};
    }
  }

  [[nodiscard]] const LoopCost& cost() const { return cost_; }

 private:
  [[nodiscard]] bool relaxing() const { return run_.state.relaxation.under_way != 0; }

  /// The phase before t = 0; false where it was asked to stop.
  bool come_to_rest(Outcome& outcome) {
    const scene::Relaxation& asked = *run_.input.relaxation;
    const model::Relaxation& phase = run_.state.relaxation;
    while (!finished(outcome)) {
      if (phase.steps >= static_cast<double>(asked.max_steps)) throw GuardError(not_at_rest(phase, asked));
      const time::RelaxationStep now = time::relax(run_.model, run_.state, run_.scratch, run_.links, run_.contact.get(),
                                                   step_control(run_), {asked.tolerance});
      if (now.step.stop) stop_for_element(now.step);
      ++passes_;
      if (now.stopped) tell_stage(phase);
      if (!now.at_rest) continue;
      log_.line(
          fmt::format("relaxation: at rest after {:.0f} steps; unbalanced forces are {:.2g} of the loads, nodes have "
                      "moved by {:.3g} "
                      "at most",
                      phase.steps, phase.residual, largest_displacement(run_)));
      begin_run(run_);
      start_ = Clock::now();
      return true;
    }
    return false;
  }

  void tell_stage(const model::Relaxation& phase) {
    if (phase.stage <= told_stage_) return;
    told_stage_ = phase.stage;
    log_.line(fmt::format("relaxation: step {:.0f}, {:.0f} % of the loads, unbalanced forces {:.2g}", phase.steps,
                          100 * phase.stage / time::relaxation_stages, phase.residual));
  }

  void go_on(Outcome& outcome) {
    results_.table_header();
    while (!finished(outcome)) {
      pass(false);
      if (due_after_step()) results_.write_checkpoint();
    }
  }

  /// Of the wall clock, until the end [s]; < 0 as long as too few steps have been taken to tell.
  [[nodiscard]] double time_left() const {
    constexpr double few = 10;
    const double share = progress(run_.state, run_.input.run);
    if (share >= 1) return 0;
    return run_.state.step - first_step_ < few ? -1 : seconds_left(seconds_since(start_), first_share_, share);
  }

  /// One step, with what is to be written about t_n.
  void pass(bool last) {
    const scene::Input& input = run_.input;
    const model::State& state = run_.state;
    const time::StepControl control = step_control(run_);
    const bool fields = last || state.step == 0 || due(state, input.output.every);
    const bool row = last || state.step == 0 || history_due(state, input);
    const bool line = last || progress(state, input.run) * table_lines >= lines_;
    const auto watch = static_cast<GlobalIndex>(state.step) % steps_between_watches == 0;

    if (fields || watch) {
      results_.watch_folds();
      results_.watch_driven();
    }
    const time::StepReport step = time::evaluate(run_.model, run_.state, run_.scratch, run_.links, control);
    if (step.stop) stop_for_element(step);
    watch_step(step);
    if (fields) results_.read_fields();
    if (row) results_.read_probes();
    time::advance(run_.model, run_.state, run_.scratch, run_.links, run_.contact.get(), step);
    if (!last) ++passes_;
    if (!last) watch_iterations();
    if (fields) results_.write_fields(&step);
    if (row || line || watch) {
      const time::Ledger ledger = energies(step);
      if (row) results_.write_history(ledger, step);
      results_.watch(ledger, state.time_before);
      if (watch && !last) results_.remember_good();
      if (line) {
        results_.table_line(ledger, step, time_left());
        lines_ = static_cast<int>(progress(state, input.run) * table_lines) + 1;
      }
    }
    if (static_cast<GlobalIndex>(state.step) % 20 == 0) log_.progress(progress(state, input.run), time_left());
  }

  time::Ledger energies(const time::StepReport& step) {
    const auto timed = run_.links.timers.measure(Phase::output);
    return time::ledger(run_.model, run_.state, run_.scratch, run_.links, run_.contact.get(), step);
  }

  bool due_after_step() { return run_.state.step > 0 && due(run_.state, run_.input.checkpoint_every); }

  /// End, wall limit, signals and the control file; all ranks decide the same.
  bool finished(Outcome& outcome) {
    if (at_end(run_.state, run_.input.run)) {
      outcome.stopped_by = run_.input.run.end && run_.state.time >= *run_.input.run.end ? "end" : "steps";
      return true;
    }
    constexpr int steps_between_looks = 10;
    if (static_cast<GlobalIndex>(run_.state.step + run_.state.relaxation.steps) % steps_between_looks != 0)
      return false;
    const Requests asked = take_requests();
    const bool root = run_.links.ranks.is_root();
    const bool late = root && run_.input.run.wall_limit && seconds_since(program_start_) > *run_.input.run.wall_limit;
    const bool control = root && std::filesystem::exists(results_.folder() + "/stop");
    double flags[4] = {asked.checkpoint ? 1.0 : 0.0, asked.stop ? 1.0 : 0.0, late ? 1.0 : 0.0, control ? 1.0 : 0.0};
    run_.links.ranks.max(flags);
    if (flags[0] > 0) log_.line("checkpoint on request: " + results_.write_checkpoint());
    if (flags[1] + flags[2] + flags[3] == 0) return false;
    outcome.code = ExitCode::on_request;
    outcome.stopped_by = flags[1] > 0 ? "signal" : flags[2] > 0 ? "wall_limit" : "control";
    if (control) std::filesystem::remove(results_.folder() + "/stop");
    return true;
  }

  /// An element that is pressed flat takes the step with it before it has no volume left: the run would not end. What
  /// damping takes from the step is not the elements' doing.
  void watch_step(const time::StepReport& step) {
    double& first = run_.extremes.first_dt;
    if (first == 0) first = step.stable_dt;
    const double ratio = run_.input.run.min_step_ratio;
    if (step.stable_dt >= ratio * first) return;
    const bool mine = step.elements.rate == step.rate;
    const ElementPlace place = place_of(run_, mine ? step.elements.block : -1, step.elements.element);
    throw GuardError(fmt::format(
        "the stable step has fallen to {:g} at t = {:g}, step {}, below run.min_step_ratio {:g} of the first, {:g}: by "
        "{}, whose shortest edge is {:.2g} and whose volume {:.2g} of what they were. Likely cause: {}; a smaller "
        "run.min_step_ratio goes on from the checkpoint",
        step.stable_dt, run_.state.time, static_cast<GlobalIndex>(run_.state.step), ratio, first, text_of(place),
        place.shortest_edge, place.volume, cause_of_collapse(place)));
  }

  /// Tells the first step of which contact was left unfinished; the summary counts them all.
  void watch_iterations() {
    if (!run_.contact || told_limit_ || run_.contact->ledger.statistics.steps_at_limit == 0) return;
    told_limit_ = true;
    const contact::EnforcementSettings& settings = run_.model.contact.enforcement;
    log_.warning(fmt::format(
        "contact: the iteration of step {} (t = {:g}) ended at max_iterations {} with a residual of {}, above the "
        "tolerance of {:g}: what is left may disturb the motion; raise max_iterations in contact (told once)",
        static_cast<GlobalIndex>(run_.state.step) - 1, run_.state.time_before, settings.max_iterations,
        told_from(run_.contact->ledger.statistics.last.residual, settings.tolerance), settings.tolerance));
  }

  [[noreturn]] void stop_for_element(const time::StepReport& step) {
    const ElementPlace place = place_of(run_, step.elements.inverted_block, step.elements.inverted_element);
    const char* cause =
        place.block < 0 ? "" : cause_of_lost_volume(run_.model.blocks[static_cast<std::size_t>(place.block)]);
    throw GuardError(fmt::format("{} has no volume left or is not a number at t = {:g}, step {}{}", text_of(place),
                                 run_.state.time, static_cast<GlobalIndex>(run_.state.step), cause));
  }

  Prepared& run_;
  Results& results_;
  Log& log_;
  Clock::time_point program_start_;  ///< for the wall limit: a batch system counts the preparation too
  Clock::time_point loop_start_ = Clock::now(), start_ = loop_start_;  ///< start_: of t = 0, or of the restart
  double first_share_ = progress(run_.state, run_.input.run);
  LoopCost cost_;
  double passes_ = 0;
  int lines_ = 0;
  double first_step_ = run_.state.step;
  double told_stage_ = 1;
  bool told_limit_ = false;
};

/// A run goes on in the folder of its checkpoint; in another one there are results of another run.
io::ExistingResults existing_results(const RunOptions& options, const std::string& checkpoint,
                                     const std::string& folder) {
  std::error_code no_folder;
  const std::filesystem::path from = std::filesystem::path(checkpoint).parent_path();
  const bool its_own = !checkpoint.empty() && std::filesystem::equivalent(from.empty() ? "." : from, folder, no_folder);
  if (its_own) return io::ExistingResults::keep;  // also by force: the checkpoint is one of the results
  return options.force ? io::ExistingResults::replace : io::ExistingResults::refuse;
}

/// Does the folder's summary tell of this very state?
bool is_told(const comm::Communicator& ranks, const std::string& folder, GlobalIndex step) {
  return ranks.any(ranks.is_root() && io::summarised_steps(folder) == step);
}

/// What this start has read, for whoever looks at the results later.
void record_scene(const Prepared& run, const RunOptions& options, const std::string& folder) {
  io::replace_text(
      folder + "/scene_as_run.yaml",
      fmt::format("# {} as {} has read it, with its overrides; paths of files are relative to that scene\n{}",
                  std::filesystem::path(options.scene).filename().string(), version(), run.scene_yaml));
}

void announce(const Prepared& run, Log& log) {
  const model::Model& model = run.model;
  log.line(fmt::format("{} ({} units)", run.input.title.empty() ? run.input.file : run.input.title, run.input.units));
  log.line(fmt::format("{} elements, {} nodes, {} parts{}, {} rank{}", model.mesh.global_elements,
                       model.mesh.global_nodes, model.blocks.size(),
                       model.bodies.empty() ? "" : fmt::format(" ({} rigid)", model.bodies.size()),
                       run.links.ranks.size(), run.links.ranks.size() == 1 ? "" : "s"));
}

void tell_iterations(const Prepared& run, Log& log) {
  if (!run.contact) return;
  const contact::ContactStatistics& contact = run.contact->ledger.statistics;
  if (contact.steps_at_limit > 0)
    log.line(
        fmt::format("contact: {} of {} steps with contact ended at max_iterations {}, with residuals of {:.2g} at most",
                    contact.steps_at_limit, contact.solved_steps, run.model.contact.enforcement.max_iterations,
                    contact.largest_residual));
}

}  // namespace

int run(const comm::Communicator& ranks, const RunOptions& options) {
  const Clock::time_point start = Clock::now();
  Log log(ranks.is_root(), options.quiet);
  const std::unique_ptr<Prepared> prepared = prepare(ranks, options.scene, options.overrides);
  refuse_overlaps(*prepared);
  const std::string checkpoint = options.restart.empty() ? "" : checkpoint_of(ranks, options.restart);
  const std::string folder =
      options.out.empty() ? std::filesystem::path(options.scene).replace_extension(".out").string() : options.out;

  std::optional<io::CheckpointHeader> restart;
  if (!checkpoint.empty()) restart = restart_from(*prepared, checkpoint);
  const io::ExistingResults existing = existing_results(options, checkpoint, folder);
  io::prepare_result_folder(ranks, folder, existing);
  on_root(ranks, [&] { log.open(folder, restart.has_value()); });
  announce(*prepared, log);
  for (const std::string& line : prepared->left_out) log.line(line);
  for (const std::string& warning : prepared->warnings) log.warning(warning);
  for (const std::string& note : prepared->overlaps.report.notes) log.line(note);
  if (restart) log.line(fmt::format("restart from {} at step {}", checkpoint, restart->step));
  const bool over = restart && at_end(prepared->state, prepared->input.run);
  if (over)
    log.warning(
        fmt::format("nothing is left to run: the checkpoint stands at t = {:g}, step {}, where this run ends; a "
                    "later run.end (or more run.steps) would go on from there",
                    prepared->state.time, restart->step));

  if (over && existing == io::ExistingResults::keep && is_told(ranks, folder, restart->step)) {
    log.line("the results in " + folder + " stay as they are");
    return static_cast<int>(ExitCode::done);
  }
  on_root(ranks, [&] { record_scene(*prepared, options, folder); });
  catch_signals();
  // the step of the checkpoint is evaluated again: its own records come anew
  Results results(*prepared, folder, restart ? std::optional(restart->step - 1) : std::nullopt, log);
  if (restart) results.warn_of_missing_rows(*restart);
  Loop loop(*prepared, results, log, start);
  Outcome outcome = loop.go();
  if (!outcome.message.empty()) log.fault("stopped: " + outcome.message);
  if (const double past = overshoot(prepared->state, prepared->input.run); past > 0.01 && !over)
    log.warning(
        fmt::format("the run ended at t = {:g}, {:.2g} % past its end: steps are never cut, and this run has few",
                    prepared->state.time, 100 * past));
  tell_iterations(*prepared, log);
  if (outcome.code != ExitCode::guard) results.write_checkpoint();
  results.seal();
  if (outcome.code == ExitCode::guard) {
    results.read_fields();  // the motion at the last step that was right
    results.write_fields(nullptr);
    if (const std::string saved = results.save_last_good(); !saved.empty()) log.line("last good state: " + saved);
  } else {
    loop.last_record(outcome);
    if (outcome.code == ExitCode::guard) log.line("stopped: " + outcome.message);
  }
  results.tell_at_end();
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
