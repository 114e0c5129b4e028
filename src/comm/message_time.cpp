// SPDX-License-Identifier: Apache-2.0
#include "comm/message_time.hpp"

#include <ctime>

namespace brunt::comm {
namespace {

// one rank is one thread (comm/one_thread.cpp)
bool timed = false;
double seconds = 0;

}  // namespace

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void time_messages(bool on) {
  timed = on;
}

double message_seconds() {
  return seconds;
}

MessageTime::MessageTime() {
  if (timed) start_ = processor_seconds();
}

MessageTime::~MessageTime() {
  if (start_ >= 0) seconds += processor_seconds() - start_;
}

}  // namespace brunt::comm
