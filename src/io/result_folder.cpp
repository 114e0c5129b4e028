// SPDX-License-Identifier: Apache-2.0
// Prepares the result folder (see the header).
#include "brunt/io/result_folder.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "brunt/core/error.hpp"
#include "brunt/io/text_file.hpp"
#include "on_root.hpp"

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

void check_writable(const fs::path& folder) {
  const std::string probe = (folder / "write_probe").string();
  replace_text(probe, "");
  fs::remove(probe);
}

void prepare_on_root(const fs::path& folder, ExistingResults existing) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw InputError(folder.string() + ": the result folder's name is taken by a file; choose another with --out");
  fs::create_directories(folder);
  const std::vector<fs::path> found = result_files(folder);
  if (!found.empty() && existing == ExistingResults::refuse)
    throw InputError(folder.string() + ": holds results already (" + found.front().filename().string() +
                     "); choose another folder with --out, replace them with --force or go on with --restart");
  check_writable(folder);
  if (existing == ExistingResults::replace)
    for (const fs::path& file : found) fs::remove(file);
}

}  // namespace

bool is_result_file(const std::string& name) {
  constexpr std::array<std::string_view, 5> fixed{"summary.json", "history.csv", "state.h5", "state.xdmf", "log.txt"};
  const bool checkpoint = name.rfind("checkpoint_", 0) == 0 && fs::path(name).extension() == ".h5";
  return checkpoint || std::find(fixed.begin(), fixed.end(), name) != fixed.end();
}

void prepare_result_folder(const comm::Communicator& ranks, const std::string& folder, ExistingResults existing) {
  on_root(ranks, [&] { prepare_on_root(folder, existing); });
}

}  // namespace brunt::io
