// SPDX-License-Identifier: Apache-2.0
// What a signal asks for, and for how long.
#include "app/program/signals.hpp"

#include <catch2/catch.hpp>
#include <csignal>

using namespace brunt;

TEST_CASE("signals: SIGUSR1 asks for one checkpoint, the others for the end") {
  app::catch_signals();
  app::Requests requests = app::take_requests();
  CHECK_FALSE(requests.checkpoint);
  CHECK_FALSE(requests.stop);
  std::raise(SIGUSR1);
  requests = app::take_requests();
  CHECK(requests.checkpoint);
  CHECK_FALSE(requests.stop);
  CHECK_FALSE(app::take_requests().checkpoint);  // it has been told
  std::raise(SIGUSR2);
  requests = app::take_requests();
  CHECK_FALSE(requests.checkpoint);
  CHECK(requests.stop);
  CHECK(app::take_requests().stop);  // the end stays the end
  for (const int signal : {SIGUSR1, SIGUSR2, SIGTERM, SIGINT}) std::signal(signal, SIG_DFL);
}
