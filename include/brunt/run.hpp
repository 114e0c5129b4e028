// SPDX-License-Identifier: Apache-2.0
// A scene, run as `brunt run` does.
#pragma once
#include <mpi.h>

#include <string>
#include <vector>

namespace brunt::api {

/// The same on all ranks.
struct RunOptions {
  std::string scene;                   ///< file
  std::string out;                     ///< result folder; empty: the scene's name with .out
  std::vector<std::string> overrides;  ///< KEY.PATH=VALUE
  std::string restart;                 ///< result folder or checkpoint; empty: from the start
  bool force = false;                  ///< replace earlier results
  bool quiet = false;                  ///< print faults only; log.txt is written as usual
};

/// The exit code of `brunt run` (0: done, 2: wrong input, 3: a guard stopped the run, 4: the machine failed, 5: stopped
/// on request); faults are printed. Results stand in the files of the result folder. Collective.
int run_scene(MPI_Comm ranks, const RunOptions& options);

}  // namespace brunt::api
