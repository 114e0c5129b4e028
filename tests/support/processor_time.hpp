// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ctime>

namespace brunt::test {

/// Of this process [s]: what others do on the machine counts only by the caches they take.
inline double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace brunt::test
