// SPDX-License-Identifier: Apache-2.0
// Prepares the result folder (see the header).
#include "io/results/result_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "core/error.hpp"
#include "io/on_root.hpp"

namespace brunt::io {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> result_files(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (is_result_file(entry.path().filename().string())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

// A folder without write permission is a wrong input; a full or failing disk is a failure of the machine.
[[noreturn]] void refuse_place(const fs::path& folder, const std::error_code& error) {
  for (const std::errc fault : {std::errc::no_space_on_device, std::errc::io_error, std::errc::not_enough_memory})
    if (error == fault) throw MachineError(folder.string() + ": " + error.message());
  throw InputError(folder.string() + ": invalid result folder (" + error.message() +
                   "); expected a writable folder, see --out");
}

void check_writable(const fs::path& folder) {
  const std::string probe = (folder / "write_probe").string();
  const int file = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0) refuse_place(folder, std::error_code(errno, std::generic_category()));
  ::close(file);
  fs::remove(probe);
}

/// A request to an earlier run, which has ended; one that came or changed since the start is kept.
bool remove_old_request(const std::string& folder, const StopRequest& at_start) {
  const StopRequest now = stop_request(folder);
  return now != StopRequest{} && now == at_start && fs::remove(fs::path(folder) / stop_file);
}

/// A run keeps a lock on its log.txt during its lifetime.
void refuse_run_in_progress(const fs::path& folder) {
  const int log = ::open((folder / "log.txt").c_str(), O_RDONLY);
  if (log < 0) return;
  const bool held = ::flock(log, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(log);
  if (held)
    throw InputError(folder.string() +
                     ": invalid result folder: another run writes into it; expected another folder, see --out");
}

bool prepare_on_root(const fs::path& folder, ExistingResults existing, const StopRequest& at_start) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw InputError(folder.string() +
                     ": invalid result folder: a file has this name; expected another name, see --out");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) refuse_place(folder, error);
  const std::vector<fs::path> found = result_files(folder);
  if (!found.empty() && existing == ExistingResults::refuse)
    throw InputError(folder.string() + ": invalid result folder: it contains results (" +
                     found.front().filename().string() +
                     "); expected another folder (--out), --force to replace the results, or --restart to continue");
  check_writable(folder);
  refuse_run_in_progress(folder);
  if (existing == ExistingResults::replace)
    for (const fs::path& file : found) fs::remove(file);
  return remove_old_request(folder.string(), at_start);
}

}  // namespace

bool is_result_file(const std::string& name) {
  constexpr std::array<std::string_view, 6> fixed{"summary.json", "history.csv", "state.h5",
                                                  "state.xdmf",   "log.txt",     "scene_as_run.yaml"};
  const bool checkpoint = name.rfind("checkpoint_", 0) == 0 && fs::path(name).extension() == ".h5";
  return checkpoint || std::find(fixed.begin(), fixed.end(), name) != fixed.end();
}

StopRequest stop_request(const std::string& folder) {
  struct stat of {};
  if (::stat((fs::path(folder) / stop_file).c_str(), &of) != 0) return {};
  return {{static_cast<std::int64_t>(of.st_dev), static_cast<std::int64_t>(of.st_ino), of.st_mtim.tv_sec,
           of.st_mtim.tv_nsec, of.st_ctim.tv_sec, of.st_ctim.tv_nsec}};
}

bool prepare_result_folder(const comm::Communicator& ranks, const std::string& folder, ExistingResults existing,
                           const StopRequest& at_start) {
  bool removed = false;
  on_root(ranks, [&] { removed = prepare_on_root(folder, existing, at_start); });
  return removed;
}

}  // namespace brunt::io
