// SPDX-License-Identifier: Apache-2.0
#include "log.hpp"

#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "core/error.hpp"

namespace brunt::app {

namespace {

/// Whether a person reads the output. mpirun gives a rank a terminal even if its own output goes to a file, so the
/// output of the parent process is examined.
bool is_looked_on() {
  if (isatty(STDOUT_FILENO) == 0) return false;
  if (!std::getenv("OMPI_COMM_WORLD_SIZE")) return true;
  std::error_code unknown;
  const std::string output =
      std::filesystem::read_symlink(fmt::format("/proc/{}/fd/{}", getppid(), STDOUT_FILENO), unknown).string();
  return output.starts_with("/dev/pts/") || output.starts_with("/dev/tty");
}

}  // namespace

Log::Log(bool speaks, bool quiet) : speaks_(speaks), quiet_(quiet), terminal_(is_looked_on()) {}

Log::~Log() {
  clear_bar();
  if (file_) std::fclose(file_);
}

void Log::open(const std::string& folder, bool append) {
  if (!speaks_) return;
  const std::string path = folder + "/log.txt";
  file_ = std::fopen(path.c_str(), "a");
  if (!file_) throw MachineError(path + ": cannot write the file");
  // see io::prepare_result_folder: another run may have started since, and a file system may have no locks
  if (flock(fileno(file_), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw InputError(folder +
                     ": invalid result folder: another run writes into it; expected another folder, see --out");
  if (!append && ftruncate(fileno(file_), 0) != 0) throw MachineError(path + ": cannot write the file");
  fmt::print(file_, "{}", before_open_);
  std::fflush(file_);
}

void Log::line(const std::string& text) {
  if (!speaks_) return;
  clear_bar();
  if (!quiet_) {
    fmt::print("{}\n", text);
    std::fflush(stdout);
  }
  if (file_) {
    fmt::print(file_, "{}\n", text);
    std::fflush(file_);
  } else {
    before_open_ += text + '\n';
  }
}

void Log::fault(const std::string& text) {
  line(text);
  if (speaks_ && quiet_) fmt::print(stderr, "brunt: {}\n", text);
}

void Log::warning(const std::string& text) {
  ++warnings_;
  line("warning: " + text);
}

void Log::progress(double share, double seconds_left) {
  if (!speaks_ || quiet_ || !terminal_) return;
  constexpr auto pause = std::chrono::milliseconds(200);
  const auto now = std::chrono::steady_clock::now();
  if (now - bar_drawn_ < pause) return;
  bar_drawn_ = now;
  constexpr int width = 40;
  const int full = static_cast<int>(std::clamp(share, 0.0, 1.0) * width);
  fmt::print("\r[{:#<{}}{:.<{}}] {:3.0f} %  {} left   ", "", full, "", width - full, 100 * share,
             clock_text(seconds_left));
  std::fflush(stdout);
  bar_shown_ = true;
}

void Log::clear_bar() {
  if (!bar_shown_) return;
  fmt::print("\r{:80}\r", "");
  bar_shown_ = false;
}

std::string clock_text(double seconds) {
  constexpr double longest = 1e9;  // [s], some thirty years
  if (!(seconds >= 0)) return "-";
  const auto whole = static_cast<long long>(std::min(seconds, longest) + 0.5);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string reported_from(double value, double limit) {
  constexpr int all_digits = 17;
  const std::string beside = fmt::format("{:g}", limit);
  std::string text;
  for (int digits = 2; digits <= all_digits; ++digits) {
    text = fmt::format("{:.{}g}", value, digits);
    if (text != beside) break;
  }
  return text;
}

}  // namespace brunt::app
