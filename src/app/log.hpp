// SPDX-License-Identifier: Apache-2.0
// What the user sees: lines on the terminal and, the same, in log.txt; a progress bar on the terminal alone.
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

  /// Starts log.txt in the folder, or goes on in it, and holds the folder for this run. What was said before is written
  /// to it first. Throws InputError where another run holds the folder; for the root alone (app::on_root).
  void open(const std::string& folder, bool append);
  void line(const std::string& text);
  void warning(const std::string& text);
  /// A line that is also told where the terminal is to stay quiet.
  void fault(const std::string& text);
  /// Redraws the bar in place, now and then, if the terminal is one; `share` 0..1.
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

/// `value` with as many digits as tell it from `limit` written as {:g}, two at least: a message that says "above" shows
/// it.
std::string reported_from(double value, double limit);

}  // namespace brunt::app
