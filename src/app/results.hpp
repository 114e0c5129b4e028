// SPDX-License-Identifier: Apache-2.0
// All files of a run: history, fields, checkpoints, summary, and what of them goes to the terminal.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "brunt/core/timers.hpp"
#include "brunt/io/checkpoint.hpp"
#include "brunt/io/history.hpp"
#include "brunt/io/state_file.hpp"
#include "brunt/time/ledger.hpp"
#include "guards.hpp"
#include "log.hpp"
#include "prepare.hpp"
#include "probes.hpp"
#include "recording.hpp"
#include "snapshot.hpp"

namespace brunt::app {

/// Which t_n a record is of.
struct RecordTime {
  GlobalIndex step = 0;
  double time = 0;
};

/// The loop as it ended: what is written after it is not its cost.
struct LoopCost {
  double seconds = 0, passes = 0;  ///< wall clock [s], output included; steps
  Timers timers;
  comm::Traffic sent{};  ///< by this rank in the loop, output left out
};

/// The last steps of which a run that goes on keeps the records that it finds.
struct KeptRecords {
  GlobalIndex fields, rows;
};

class Results {
 public:
  /// Opens the files of the folder; `kept`: goes on in them. Collective.
  Results(Prepared& run, std::string folder, const std::optional<KeptRecords>& kept, Log& log);

  /// Tells of rows that history.csv had when the checkpoint was written and has no more.
  void warn_of_missing_rows(const io::CheckpointHeader& checkpoint);

  /// Between evaluate and advance: fields and probes of t_n.
  void read_fields();
  void read_probes() { probes_.read_motion(run_); }
  /// The fields that were read, with those of contact where `step` has been taken. Collective.
  void write_fields(const time::StepReport* step);
  /// The row of t_n; in explicit runs after advance.
  void write_history(const time::Ledger& ledger, const time::StepReport& step, const RecordTime& at);
  /// Keeps account of a ledger; warns where the energy may not be right, throws GuardError where it cannot be.
  /// Collective.
  void watch(const time::Ledger& ledger, double time);
  /// Counts elements folded at x_n, and warns of the first that are seen. Collective.
  void watch_folds();
  /// Warns of parts that supports move through each other, and follows how deep. Collective.
  void watch_driven();
  /// Warns where hourglass control has taken up more than belongs to it, or contact more than an impact loses.
  void report_at_end();
  std::string write_checkpoint();
  /// Remembers the state of t_n, which all guards have let pass. Collective.
  void remember_good();
  /// After a guard: a checkpoint of the remembered state, which becomes the state of the run; nothing, and empty, where
  /// a newer checkpoint was written. Collective.
  std::string save_last_good();
  /// Remembers where the run stands: the summary is about this state, also if one more record is taken. Collective.
  void seal();
  void write_summary(const std::string& stopped_by, int exit_code, double wall_seconds, const LoopCost& cost);
  void table_header();
  /// `seconds_left`: of the wall clock until the end, as far as can be told; below 0: not yet.
  void table_line(const time::Ledger& ledger, const time::StepReport& step, const RecordTime& at, double seconds_left);
  /// Books what follows to output, up to the end of what is returned.
  [[nodiscard]] Recording record() { return {run_.links, sent_}; }
  [[nodiscard]] const comm::Traffic& sent() const { return sent_; }  ///< by this rank, for output
  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] const Extremes& extremes() const { return run_.extremes; }

 private:
  [[nodiscard]] std::string where(Fault fault) const;
  void report_hourglass();
  void report_parted();
  Prepared& run_;
  std::string folder_;
  Log& log_;
  Probes probes_;
  std::unique_ptr<io::HistoryFile> history_;
  std::unique_ptr<io::StateFile> states_;
  std::vector<io::StateField> fields_;
  double fields_step_ = 0, fields_time_ = 0;
  time::Ledger last_ledger_;
  GlobalIndex folded_ = 0;                        ///< largest number of folded elements seen at one look
  std::array<bool, guarded_columns> reported_{};  ///< of which a warning has been given
  double extent_ = 0;                             ///< half of the diagonal of the model at the start [length]
  comm::Traffic sent_;
  Snapshot last_good_;
  double checkpoint_step_ = -1;  // of the last checkpoint written in this run
  std::uint64_t hash_ = 0;
  double steps_ = 0, end_time_ = 0;
  contact::ContactStatistics contact_;
};

}  // namespace brunt::app
