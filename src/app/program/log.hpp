// SPDX-License-Identifier: Apache-2.0
// Output for the user: lines on the terminal and in log.txt; a progress bar on the terminal only.
#pragma once
#include <chrono>
#include <cstdio>
#include <string>

namespace brunt::app {

class Log {
 public:
  /// Silent on ranks other than the root.
  Log(bool speaks, bool quiet);
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  /// Starts or continues log.txt in the folder, and locks the folder for this run. Earlier lines are written to it
  /// first. Throws InputError if another run has locked the folder; for the root only (app::on_root).
  void open(const std::string& folder, bool append);
  void line(const std::string& text);
  void warning(const std::string& text);
  /// A line that is also printed if the terminal is quiet.
  void fault(const std::string& text);
  /// Redraws the bar from time to time, if the output is a terminal; `share` 0..1.
  void progress(double share, double seconds_left);
  [[nodiscard]] int warnings() const { return warnings_; }

 private:
  void clear_bar();
  bool speaks_, quiet_, terminal_;
  bool bar_shown_ = false;
  std::chrono::steady_clock::time_point bar_drawn_{};
  int warnings_ = 0;
  std::string before_open_;
  std::FILE* file_ = nullptr;
};

/// A duration as h:mm:ss; a dash below 0.
std::string clock_text(double seconds);

/// `value` with enough digits to distinguish it from `limit` written as {:g}, at least two: a message with "above" then
/// shows a difference.
std::string reported_from(double value, double limit);

}  // namespace brunt::app
