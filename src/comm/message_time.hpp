// SPDX-License-Identifier: Apache-2.0
// Processor time of this rank with and without its messages. A waiting rank also uses processor time, so the cost of
// its own work is its processor time less that spent in messages. Reading the clock is a system call; messages are
// therefore timed only on request.
#pragma once

namespace brunt::comm {

/// Processor time of this thread so far [s].
[[nodiscard]] double processor_seconds();

/// Turns the timing of messages on or off.
void time_messages(bool on);
/// Processor time that this rank has spent in messages while they were timed [s].
[[nodiscard]] double message_seconds();

/// Counts the time between its construction and its destruction as message time. Nested objects would count twice, so
/// only the innermost functions use it.
class MessageTime {
 public:
  MessageTime();
  ~MessageTime();
  MessageTime(const MessageTime&) = delete;
  MessageTime& operator=(const MessageTime&) = delete;

 private:
  double start_ = -1;
};

}  // namespace brunt::comm
