// SPDX-License-Identifier: Apache-2.0
// From what went wrong to the exit code, and faults that the root rank alone can see told to all.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/core/error.hpp"

namespace brunt::app {

/// Runs the command; prints what it throws (the user's faults once, from the root) and returns the exit code. A failure
/// that other ranks cannot know of ends them all.
int guarded(const comm::Communicator& ranks, const std::function<int()>& command);

/// Throws on every rank what was thrown on rank `from`. Collective.
void share_faults(const comm::Communicator& ranks, std::vector<std::string> faults, Rank from = 0);

/// Calls `work` on the root; an InputError there becomes one on every rank. Collective.
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

/// Writes the code to the file that BRUNT_EXIT_FILE names, and returns what the process should then return: mpirun does
/// not always hand a code through, and waits long for the other ranks if one of them returns more than 0.
int leave_exit_code(int code, bool root);

}  // namespace brunt::app
