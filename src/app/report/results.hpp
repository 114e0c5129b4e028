// SPDX-License-Identifier: Apache-2.0
// All files of a run: history, fields, checkpoints, summary, and their output on the terminal.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/program/log.hpp"
#include "app/state/guards.hpp"
#include "app/state/prepared.hpp"
#include "app/watch/depth_watch.hpp"
#include "core/timers.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/history.hpp"
#include "io/results/state_file.hpp"
#include "probes.hpp"
#include "recording.hpp"
#include "snapshot.hpp"
#include "time/ledger.hpp"

namespace brunt::app {

/// The t_n of a record.
struct RecordTime {
  GlobalIndex step = 0;
  double time = 0;
};

/// The loop at its end: later output is not part of its cost.
struct LoopCost {
  double seconds = 0, passes = 0;  ///< wall clock [s], output included; steps
  Timers timers;
  comm::Traffic sent{};  ///< by this rank in the loop, output left out
};

/// The last steps whose records are kept when a run is continued.
struct KeptRecords {
  GlobalIndex fields, rows;
};

class Results {
 public:
  /// Opens the files of the folder; `kept`: continues them. Collective.
  Results(Prepared& run, std::string folder, const std::optional<KeptRecords>& kept, Log& log);

  /// Warns of rows that history.csv had when the checkpoint was written and that are missing now.
  void warn_of_missing_rows(const io::CheckpointHeader& checkpoint);

  /// Between evaluate and advance: fields and probes of t_n.
  void read_fields();
  void read_probes() { probes_.read_motion(run_); }
  /// The fields that were read, with those of contact where `step` has been taken. Collective.
  void write_fields(const time::StepReport* step);
  /// The row of t_n; in explicit runs after advance.
  void write_history(const time::Ledger& ledger, const time::StepReport& step, const RecordTime& at);
  /// Evaluates a ledger; warns if the energy may be wrong, throws GuardError if it is. Collective.
  void watch(const time::Ledger& ledger, double time);
  /// At the end of a run whose energies are judged as shares of the whole (note_worst): warns, and throws GuardError if
  /// the run is complete. Collective.
  void judge_whole_run(bool complete);
  /// Counts the elements folded at x_n, and warns of the first ones. Collective.
  void watch_folds();
  /// Warns of parts that supports move through each other, and records the depth. Collective.
  void watch_driven();
  /// Warns of nodes and edges that lie in other bodies at x_n, and records the depth: always, or if bodies have moved
  /// far enough since the last look. Collective.
  void watch_depth(bool always);
  /// Throws GuardError if their depth is beyond what is admitted.
  void stop_if_driven();
  /// Warns if hourglass control took up too much energy, or contact more than the loss of an impact.
  void report_at_end();
  std::string write_checkpoint();
  /// A pass through the loop has evaluated the state of this step, and no guard has stopped there: a checkpoint of it
  /// is good.
  void accept(double step);
  /// Stores the state of t_n, which all guards have accepted. Collective.
  void remember_good();
  /// After a guard: removes a checkpoint whose state no pass has accepted, and writes one of the stored state, which
  /// becomes the state of the run. Returns the newest good checkpoint, or an empty path. Collective.
  std::string save_last_good();
  /// Stores the state of the run for the summary, even if one more record is written. Collective.
  void seal();
  void write_summary(const std::string& stopped_by, int exit_code, double wall_seconds, const LoopCost& cost);
  void table_header();
  /// `seconds_left`: of the wall clock until the end, as far as can be told; below 0: not yet.
  void table_line(const time::Ledger& ledger, const time::StepReport& step, const RecordTime& at, double seconds_left);
  /// Counts the time until the returned object is destroyed as output.
  [[nodiscard]] Recording record() { return {run_.links, sent_}; }
  [[nodiscard]] const comm::Traffic& sent() const { return sent_; }  ///< by this rank, for output
  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] const Extremes& extremes() const { return run_.extremes; }

 private:
  [[nodiscard]] std::string where(Fault fault) const;
  [[nodiscard]] std::string cause_of(Fault fault) const;
  [[nodiscard]] double rounding(const time::Ledger& ledger) const;
  void report_hourglass();
  void report_parted();
  void report_scaled();
  void report_turned();
  Prepared& run_;
  std::string folder_;
  Log& log_;
  Probes probes_;
  std::unique_ptr<io::HistoryFile> history_;
  std::unique_ptr<io::StateFile> states_;
  std::vector<io::StateField> fields_;
  double fields_step_ = 0, fields_time_ = 0;
  time::Ledger last_ledger_;
  GlobalIndex folded_ = 0;  ///< largest number of folded elements seen at one look
  DepthWatch depth_;
  std::array<bool, guarded_columns> reported_{};  ///< of which a warning has been given
  bool judged_ = false;                           ///< as a whole run
  double extent_ = 0;                             ///< half of the diagonal of the model at the start [length]
  comm::Traffic sent_;
  Snapshot last_good_;
  double checkpoint_step_ = -1;  // of the last checkpoint written in this run
  std::string checkpoint_;       // its path
  double accepted_step_ = -1;    // of the last accepted checkpoint of this run
  std::string accepted_;         // its path
  std::uint64_t hash_ = 0;
  double steps_ = 0, end_time_ = 0;
  contact::ContactStatistics contact_;
};

}  // namespace brunt::app
