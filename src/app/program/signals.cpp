// SPDX-License-Identifier: Apache-2.0
#include "signals.hpp"

#include <csignal>
#include <initializer_list>

namespace brunt::app {
namespace {

volatile std::sig_atomic_t checkpoint_requested = 0;
volatile std::sig_atomic_t stop_requested = 0;

extern "C" void on_signal(int signal) {
  if (signal == SIGUSR1)
    checkpoint_requested = 1;
  else
    stop_requested = 1;
}

}  // namespace

void catch_signals() {
  for (const int signal : {SIGUSR1, SIGUSR2, SIGTERM, SIGINT}) std::signal(signal, on_signal);
}

Requests take_requests() {
  const Requests requests{checkpoint_requested != 0, stop_requested != 0};
  checkpoint_requested = 0;
  return requests;
}

}  // namespace brunt::app
