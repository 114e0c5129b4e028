// SPDX-License-Identifier: Apache-2.0
// `brunt run`: the loop over time steps, and the schedule of output.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.hpp"

namespace brunt::app {

struct RunOptions {
  std::string scene;
  std::string out;  ///< empty: SCENE.out beside the scene's name
  std::vector<std::string> overrides;
  std::string restart;    ///< result folder or checkpoint file; empty: from the start
  std::string partition;  ///< file of `brunt partition --write`; empty: the usual partition
  bool force = false;
  bool quiet = false;
};

/// Returns the exit code. Collective.
int run(const comm::Communicator& ranks, const RunOptions& options);

}  // namespace brunt::app
