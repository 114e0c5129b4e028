// SPDX-License-Identifier: Apache-2.0
// Processor time of this rank with and without its messages: a rank that waits for others is busy too, so what its own
// work costs is processor time less that spent in messages. Asking the clock is a system call, so messages are timed
// only where someone asks for it.
#pragma once

namespace brunt::comm {

/// Processor time of this thread so far [s].
[[nodiscard]] double processor_seconds();

/// From now on messages are timed, or not.
void time_messages(bool on);
/// Processor time that this rank has spent in messages while they were timed [s].
[[nodiscard]] double message_seconds();

/// Books the time from its making to its end as that of a message. One inside another counts twice: leaf functions
/// only.
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
