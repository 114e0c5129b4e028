// SPDX-License-Identifier: Apache-2.0
// Cost of output and guards, separated from the steps: seconds and messages.
#pragma once
#include "comm/traffic.hpp"
#include "core/timers.hpp"
#include "time/links.hpp"

namespace brunt::app {

/// Counts the time and the messages between its construction and its destruction as output. A nested one has no effect.
class Recording {
 public:
  Recording(time::Links& links, comm::Traffic& sent)
      : ranks_(links.ranks), sent_(sent), before_(sent_by(ranks_)), timed_(links.timers.measure(Phase::output)) {}
  ~Recording() { sent_ = sent_ + (sent_by(ranks_) - before_); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

 private:
  const comm::Communicator& ranks_;
  comm::Traffic& sent_;
  comm::Traffic before_;
  Timers::Measure timed_;
};

}  // namespace brunt::app
