// SPDX-License-Identifier: Apache-2.0
// From exceptions to exit codes; distribution of faults that only the root rank can detect.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "comm/communicator.hpp"
#include "core/error.hpp"

namespace brunt::app {

/// Runs the command; prints exceptions (faults of the input once, by the root) and returns the exit code. A failure
/// that other ranks cannot know ends them all.
int guarded(const comm::Communicator& ranks, const std::function<int()>& command);

/// Throws on every rank the exception of rank `from`. Collective.
void share_faults(const comm::Communicator& ranks, std::vector<std::string> faults, Rank from = 0);

/// Calls `work` on the root; an InputError there is thrown on every rank. Collective.
template <class Work>
void on_root(const comm::Communicator& ranks, Work&& work) {
  std::vector<std::string> faults;
  if (ranks.is_root()) {
    try {
      std::forward<Work>(work)();
    } catch (const InputError& error) {
      faults = error.faults();
    }
  }
  share_faults(ranks, std::move(faults));
}

/// Writes the code to the file named by BRUNT_EXIT_FILE, and returns the return value of the process: mpirun does not
/// always pass a code on, and waits long for the other ranks if one of them returns more than 0.
int leave_exit_code(int code, bool root);

}  // namespace brunt::app
