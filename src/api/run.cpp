// SPDX-License-Identifier: Apache-2.0
#include "brunt/run.hpp"

#include "app/program/failure.hpp"
#include "app/run/run.hpp"
#include "comm/native.hpp"

namespace brunt::api {

int run_scene(MPI_Comm on, const RunOptions& options) {
  const comm::Communicator ranks = comm::NativeAccess::on(on);
  const app::RunOptions inner{.scene = options.scene,
                              .out = options.out,
                              .overrides = options.overrides,
                              .restart = options.restart,
                              .partition = {},
                              .force = options.force,
                              .quiet = options.quiet};
  return app::guarded(ranks, [&] { return app::run(ranks, inner); });
}

}  // namespace brunt::api
