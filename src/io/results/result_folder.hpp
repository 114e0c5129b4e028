// SPDX-License-Identifier: Apache-2.0
// The folder that holds the results of a run.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "comm/communicator.hpp"

namespace brunt::io {

/// Which control file a result folder has, whatever its clock says. All zero: none.
struct StopRequest {
  std::array<std::int64_t, 6> identity{};  ///< device, inode, and seconds and nanoseconds of its two changes
  friend bool operator==(const StopRequest&, const StopRequest&) = default;
};
[[nodiscard]] StopRequest stop_request(const std::string& folder);

enum class ExistingResults {
  refuse,   ///< an InputError
  replace,  ///< --force: result files of an earlier run are removed; other files are kept
  keep      ///< --restart: the run continues in them
};

/// Creates the folder (and its parents) if necessary and checks that files can be written there. Collective; all ranks
/// throw the same: InputError if results exist but must not, or nothing can be written there; MachineError if the disk
/// is full or fails. A control file (`stop`) that has not changed since `at_start` is removed; true on the root if
/// there was one.
bool prepare_result_folder(const comm::Communicator& ranks, const std::string& folder, ExistingResults existing,
                           const StopRequest& at_start);

/// The file by which a user stops a run, in its result folder.
constexpr const char* stop_file = "stop";

/// True for the files that a run writes: summary.json, history.csv, state.h5, state.xdmf, checkpoint_*.h5, log.txt,
/// scene_as_run.yaml.
[[nodiscard]] bool is_result_file(const std::string& name);

}  // namespace brunt::io
