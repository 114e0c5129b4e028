// SPDX-License-Identifier: Apache-2.0
// Requests from outside: SIGUSR1 checkpoint and go on; SIGUSR2, SIGTERM, SIGINT checkpoint and stop.
#pragma once

namespace brunt::app {

struct Requests {
  bool checkpoint = false;
  bool stop = false;
};

void catch_signals();

/// What has been asked of this rank since the last call.
Requests take_requests();

}  // namespace brunt::app
