// SPDX-License-Identifier: Apache-2.0
// The loop over the steps of a run: what is due when, and why it ends.
#pragma once
#include <chrono>
#include <string>

#include "app/program/failure.hpp"
#include "app/program/log.hpp"
#include "app/report/results.hpp"
#include "app/state/prepared.hpp"
#include "schedule.hpp"

namespace brunt::app {

using Clock = std::chrono::steady_clock;
inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Why the loop ended.
struct Outcome {
  std::string stopped_by = "end";
  ExitCode code = ExitCode::done;
  std::string message;
};

class Loop {
 public:
  Loop(Prepared& run, Results& results, Log& log, Clock::time_point program_start)
      : run_(run), results_(results), log_(log), program_start_(program_start) {}

  Outcome go();

  /// Evaluates t_N once more for its fields and its ledger; the step that this takes is not part of the run. A guard
  /// may find there what it has not seen before.
  void last_record(Outcome& outcome);

  [[nodiscard]] const LoopCost& cost() const { return cost_; }

 private:
  [[nodiscard]] bool relaxing() const { return run_.state.relaxation.under_way != 0; }

  /// The phase before t = 0; false where it was asked to stop.
  bool come_to_rest(Outcome& outcome);

  void report_stage(const model::Relaxation& phase);

  void go_on(Outcome& outcome);

  /// Of the wall clock, until the end [s]; < 0 as long as too few steps have been taken to tell.
  [[nodiscard]] double time_left() const;

  /// One step, with what is to be written about t_n.
  void pass(bool last);

  /// The two halves of an explicit step; `sampled`: their work is measured.
  time::StepReport evaluate(const time::StepControl& control, bool sampled);
  void advance(const time::StepReport& step, bool sampled);

  /// The same of an implicit run, where records are of the end of the step; `last`: what the end of a run has to write.
  void pass_implicit();
  void record_implicit(bool last);

  time::Ledger energies(const time::StepReport& step);

  bool due_after_step() {
    const double slack = run_.implicit ? implicit_slack : 0.0;
    return run_.state.step > 0 && due(run_.state, run_.input.checkpoint_every, slack);
  }

  /// End, wall limit, signals and the control file; all ranks decide the same.
  bool finished(Outcome& outcome);

  /// An element that is pressed flat takes the step with it before it has no volume left: the run would not end. What
  /// damping takes from the step is not the elements' doing.
  void watch_step(const time::StepReport& step);

  /// Tells the first step of which contact was left unfinished; the summary counts them all.
  void watch_iterations();

  [[noreturn]] void stop_for_element(const time::StepReport& step);

  Prepared& run_;
  Results& results_;
  Log& log_;
  Clock::time_point program_start_;  ///< for the wall limit: a batch system counts the preparation too
  Clock::time_point loop_start_ = Clock::now(), start_ = loop_start_;  ///< start_: of t = 0, or of the restart
  double first_share_ = progress(run_.state, run_.input.run);
  comm::Traffic sent_before_ = sent_by(run_.links.ranks);
  LoopCost cost_;
  double passes_ = 0;
  int lines_ = 0;
  double first_step_ = run_.state.step;
  double reported_stage_ = 1;
  bool reported_limit_ = false;
};

}  // namespace brunt::app
