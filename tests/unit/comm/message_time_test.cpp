// SPDX-License-Identifier: Apache-2.0
// Messages are booked where that was asked for, and nowhere else.
#include "comm/message_time.hpp"

#include <catch2/catch.hpp>

using namespace brunt;

namespace {

/// Keeps the processor busy for some time [s]; by the same clock.
void work(double seconds) {
  const double end = comm::processor_seconds() + seconds;
  while (comm::processor_seconds() < end) {
  }
}

}  // namespace

TEST_CASE("message time: booked while messages are timed, and not else") {
  const double before = comm::message_seconds();
  {
    const comm::MessageTime untimed;
    work(0.002);
  }
  CHECK(comm::message_seconds() == before);
  comm::time_messages(true);
  {
    const comm::MessageTime timed;
    work(0.002);
  }
  comm::time_messages(false);
  CHECK(comm::message_seconds() - before >= 0.0019);  // of 0.002, less rounding
  const double after = comm::message_seconds();
  work(0.001);
  CHECK(comm::message_seconds() == after);
}
