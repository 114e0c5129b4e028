// SPDX-License-Identifier: Apache-2.0
// External requests: SIGUSR1 checkpoint and continue; SIGUSR2, SIGTERM, SIGINT checkpoint and stop.
#pragma once

namespace brunt::app {

struct Requests {
  bool checkpoint = false;
  bool stop = false;
};

void catch_signals();

/// The requests to this rank since the last call.
Requests take_requests();

}  // namespace brunt::app
