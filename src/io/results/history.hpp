// SPDX-License-Identifier: Apache-2.0
// history.csv: one row for each history step; the first column is the step.
#pragma once
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt::io {

struct HistoryColumn {
  std::string name;  ///< letters, digits, `_`, `.`
  std::string unit;  ///< shown in brackets; empty: none shown
};

/// The open file. Not collective: for the root rank. Every row is passed to the operating system at once.
class HistoryFile {
 public:
  /// `columns` follow `step`. With `restart_step` an existing file is continued: rows of later steps, and an incomplete
  /// last row of a killed run, are removed; different columns are an InputError. Throws MachineError.
  HistoryFile(std::string path, const std::vector<HistoryColumn>& columns,
              std::optional<GlobalIndex> restart_step = std::nullopt);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// One value for each column, in the shortest form that reads back to the same bits.
  void write(GlobalIndex step, std::span<const double> values);

  [[nodiscard]] GlobalIndex rows() const { return rows_; }            ///< including those kept at a restart
  [[nodiscard]] GlobalIndex last_step() const { return last_step_; }  ///< of the last row written here; -1: none

 private:
  std::string path_;
  std::size_t columns_ = 0;
  GlobalIndex rows_ = 0, last_step_ = -1;
  std::FILE* file_ = nullptr;
};

/// A history as read: names without units, and one row of `names.size()` values a history step (step first).
struct History {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
};

/// Missing rows of a history.
struct HistoryGap {
  GlobalIndex missing = 0;
  double from = 0, to = 0;  ///< times of the largest gap between rows [time]
};

/// For a file that should have `expected` rows up to the time `until`; empty if it has them.
[[nodiscard]] std::optional<HistoryGap> history_gap(const std::string& path, GlobalIndex expected, double until);

[[nodiscard]] History read_history(const std::string& path);

}  // namespace brunt::io
