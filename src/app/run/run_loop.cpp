// SPDX-License-Identifier: Apache-2.0
#include "run_loop.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/program/signals.hpp"
#include "app/report/implicit_report.hpp"
#include "app/state/contact_setup.hpp"
#include "app/state/removal.hpp"
#include "app/watch/stop_causes.hpp"
#include "core/error.hpp"
#include "implicit_loop.hpp"
#include "io/results/result_folder.hpp"
#include "schedule.hpp"
#include "time/relaxation.hpp"
#include "time/step.hpp"

namespace brunt::app {
namespace {

constexpr int steps_between_watches = 200;  // the ledger costs a pass over all nodes, a look at folds one of elements
constexpr int table_lines = 20;             // about so many over a run

/// Of all nodes [length]. Collective.
double largest_displacement(const Prepared& run) {
  double largest = 0;
  for (const Quad& u : run.state.displacement) largest = std::max(largest, u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  return std::sqrt(run.links.ranks.max(largest));
}

}  // namespace

Outcome Loop::go() {
  Outcome outcome;
  try {
    if (!relaxing() || come_to_rest(outcome)) go_on(outcome);
  } catch (const GuardError& error) {
    outcome = {"guard", ExitCode::guard, error.what()};
  }
  cost_ = {seconds_since(loop_start_), passes_, run_.links.timers,
           sent_by(run_.links.ranks) - sent_before_ - results_.sent()};
  return outcome;
}

void Loop::last_record(Outcome& outcome) {
  try {
    if (run_.implicit) {
      record_implicit(true);
      results_.judge_whole_run(outcome.code == ExitCode::done);
    } else if (!relaxing()) {
      pass(true);  // before t = 0 there is nothing to tell
    }
  } catch (const GuardError& error) {
    outcome = {"guard", ExitCode::guard, error.what()};
  }
}

bool Loop::come_to_rest(Outcome& outcome) {
  const scene::Relaxation& asked = *run_.input.relaxation;
  const model::Relaxation& phase = run_.state.relaxation;
  while (!finished(outcome)) {
    if (phase.steps >= static_cast<double>(asked.max_steps)) throw GuardError(not_at_rest(phase, asked));
    const time::RelaxationStep now = time::relax(run_.model, run_.state, run_.scratch, run_.links, run_.contact.get(),
                                                 step_control(run_), {asked.tolerance});
    if (now.step.stop) stop_for_element(now.step);
    ++passes_;
    if (now.stopped) report_stage(phase);
    if (!now.at_rest) continue;
    log_.line(
        fmt::format("relaxation: at rest after {:.0f} steps; unbalanced forces are {:.2g} of the loads, the largest "
                    "displacement is {:.3g}",
                    phase.steps, phase.residual, largest_displacement(run_)));
    begin_run(run_);
    start_ = Clock::now();
    return true;
  }
  return false;
}

void Loop::report_stage(const model::Relaxation& phase) {
  if (phase.stage <= reported_stage_) return;
  reported_stage_ = phase.stage;
  log_.line(fmt::format("relaxation: step {:.0f}, {:.0f} % of the loads, unbalanced forces {:.2g}", phase.steps,
                        100 * phase.stage / time::relaxation_stages, phase.residual));
}

void Loop::go_on(Outcome& outcome) {
  results_.table_header();
  if (run_.implicit && run_.state.step == 0) record_implicit(false);
  while (!finished(outcome)) {
    if (run_.implicit)
      pass_implicit();
    else
      pass(false);
    if (due_after_step()) results_.write_checkpoint();
  }
}

double Loop::time_left() const {
  constexpr double few = 10;
  const double share = progress(run_.state, run_.input.run);
  if (share >= 1) return 0;
  return run_.state.step - first_step_ < few ? -1 : seconds_left(seconds_since(start_), first_share_, share);
}

void Loop::pass(bool last) {
  const scene::Input& input = run_.input;
  const model::State& state = run_.state;
  const double step_here = state.step;
  const time::StepControl control = step_control(run_);
  const bool fields = last || state.step == 0 || due(state, input.output.every);
  const bool row = last || state.step == 0 || history_due(state, input);
  const bool line = last || progress(state, input.run) * table_lines >= lines_;
  const auto watch = static_cast<GlobalIndex>(state.step) % steps_between_watches == 0;

  if (fields || watch) {
    results_.watch_folds();
    results_.watch_driven();
  }
  results_.watch_depth(fields || watch);
  const bool sampled = static_cast<GlobalIndex>(state.step) % steps_between_samples == 0;
  const time::StepReport step = evaluate(control, sampled);
  if (step.stop) stop_for_element(step);
  watch_step(step);
  remove_due(run_, log_);
  if (fields) results_.read_fields();
  if (row) results_.read_probes();
  advance(step, sampled);
  results_.stop_if_driven();
  if (!last) ++passes_;
  if (!last) watch_iterations();
  if (fields) results_.write_fields(&step);
  if (row || line || watch) {
    const time::Ledger ledger = energies(step);
    const RecordTime at{static_cast<GlobalIndex>(state.step) - 1, state.time_before};
    if (row) results_.write_history(ledger, step, at);
    results_.watch(ledger, state.time_before);
    if (watch && !last) results_.remember_good();
    if (line) {
      results_.table_line(ledger, step, at, time_left());
      lines_ = static_cast<int>(progress(state, input.run) * table_lines) + 1;
    }
  }
  results_.accept(step_here);
  if (static_cast<GlobalIndex>(state.step) % 20 == 0) log_.progress(progress(state, input.run), time_left());
}

time::StepReport Loop::evaluate(const time::StepControl& control, bool sampled) {
  const WorkSample sample(run_.work.evaluate, sampled);
  return time::evaluate(run_.model, run_.state, run_.scratch, run_.links, control);
}

void Loop::advance(const time::StepReport& step, bool sampled) {
  const double motion = run_.links.timers.seconds(Phase::other);
  {
    const WorkSample sample(run_.work.advance, sampled);
    time::advance(run_.model, run_.state, run_.scratch, run_.links, run_.contact.get(), step);
  }
  if (!sampled) return;
  run_.work.contact = run_.contact != nullptr;
  run_.work.motion += run_.links.timers.seconds(Phase::other) - motion;
  ++run_.work.steps;
}

void Loop::pass_implicit() {
  implicit_step(run_);
  for (const std::string& warning : warnings_of_stability(run_)) log_.warning(warning);
  ++passes_;
  results_.remember_good();
  record_implicit(false);
  log_.progress(progress(run_.state, run_.input.run), time_left());
}

void Loop::record_implicit(bool last) {
  const scene::Input& input = run_.input;
  const model::State& state = run_.state;
  // what is written because the run ends comes after its checkpoint: the run that goes on has not seen it
  const bool first = state.step == 0;
  const bool fields_due = first || due(state, input.output.every, implicit_slack);
  const bool row_due = first || implicit_row_due(state, input);
  const ImplicitRecord record{.fields = fields_due != last,
                              .row = row_due != last,
                              .line = last || progress(state, input.run) * table_lines >= lines_};
  write_implicit_record(run_, results_, record, time_left());
  if (record.line) lines_ = static_cast<int>(progress(state, input.run) * table_lines) + 1;
}

time::Ledger Loop::energies(const time::StepReport& step) {
  const Recording recording = results_.record();
  return time::ledger(run_.model, run_.state, run_.scratch, run_.links, run_.contact.get(), step);
}

bool Loop::finished(Outcome& outcome) {
  if (at_end(run_.state, run_.input.run, run_.implicit ? implicit_slack : 0.0)) {
    outcome.stopped_by =
        run_.input.run.steps && run_.state.step >= static_cast<double>(*run_.input.run.steps) ? "steps" : "end";
    return true;
  }
  constexpr int steps_between_looks = 10;
  const auto steps = static_cast<GlobalIndex>(run_.state.step + run_.state.relaxation.steps);
  if (!run_.implicit && steps % steps_between_looks != 0) return false;  // implicit steps are long
  const Requests asked = take_requests();
  const bool root = run_.links.ranks.is_root();
  const bool late = root && run_.input.run.wall_limit && seconds_since(program_start_) > *run_.input.run.wall_limit;
  const bool control = root && std::filesystem::exists(results_.folder() + '/' + io::stop_file);
  double flags[4] = {asked.checkpoint ? 1.0 : 0.0, asked.stop ? 1.0 : 0.0, late ? 1.0 : 0.0, control ? 1.0 : 0.0};
  run_.links.ranks.max(flags);
  if (flags[0] > 0) log_.line("checkpoint on request: " + results_.write_checkpoint());
  if (flags[1] + flags[2] + flags[3] == 0) return false;
  outcome.code = ExitCode::on_request;
  outcome.stopped_by = flags[1] > 0 ? "signal" : flags[2] > 0 ? "wall_limit" : "control";
  if (control) std::filesystem::remove(results_.folder() + '/' + io::stop_file);
  return true;
}

void Loop::watch_step(const time::StepReport& step) {
  double& first = run_.extremes.first_dt;
  if (first == 0) first = step.stable_dt;
  const double ratio = run_.input.run.min_step_ratio;
  if (step.stable_dt >= ratio * first) return;
  const bool mine = step.elements.rate == step.rate;
  const ElementPlace place = place_of(run_, mine ? step.elements.block : -1, step.elements.element);
  throw GuardError(
      fmt::format("the stable step has decreased to {:g} at t = {:g}, step {}, below run.min_step_ratio {:g} of the "
                  "first, {:g}: due to {}, whose shortest edge is {:.2g} and whose volume {:.2g} of the initial one. "
                  "Likely cause: {}; with a smaller run.min_step_ratio the run continues from the checkpoint",
                  step.stable_dt, run_.state.time, static_cast<GlobalIndex>(run_.state.step), ratio, first,
                  text_of(place), place.shortest_edge, place.volume, cause_of_collapse(place)));
}

void Loop::watch_iterations() {
  if (!run_.contact || reported_limit_ || run_.contact->ledger.statistics.steps_at_limit == 0) return;
  reported_limit_ = true;
  const contact::EnforcementSettings& settings = run_.model.touching.contact.enforcement;
  log_.warning(fmt::format(
      "contact: the iteration of step {} (t = {:g}) ended at max_iterations {} with a residual of {}, above the "
      "tolerance of {:g}: the remainder may disturb the motion; increase enforcement.max_iterations{} (reported once)",
      static_cast<GlobalIndex>(run_.state.step) - 1, run_.state.time_before, settings.max_iterations,
      reported_from(run_.contact->ledger.statistics.last.residual, settings.tolerance), settings.tolerance,
      run_.contact->settings.rigid.supported && !run_.input.prescribed.empty()
          ? "; no number suffices where supports move a rigid part into an obstacle that cannot yield while the part "
            "may rotate or slide: constrain these motions too, or do not move it there"
          : ""));
}

void Loop::stop_for_element(const time::StepReport& step) {
  const ElementPlace place = place_of(run_, step.elements.inverted_block, step.elements.inverted_element);
  const char* cause = place.block < 0 ? "" : cause_of_lost_volume(nth(run_.model.blocks, place.block));
  throw GuardError(fmt::format("{} has no volume left, or values that are not finite, at t = {:g}, step {}{}",
                               text_of(place), run_.state.time, static_cast<GlobalIndex>(run_.state.step), cause));
}

}  // namespace brunt::app
