// SPDX-License-Identifier: Apache-2.0
#include "start_up.hpp"

#include <malloc.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

namespace brunt::app {

void StartUp::end(StartStage stage) {
  const auto at = static_cast<std::size_t>(stage);
  const Clock::time_point now = Clock::now();
  seconds_[at] += std::chrono::duration<double>(now - last_).count();
  peak_bytes_[at] = peak_memory();
  last_ = now;
}

nlohmann::ordered_json StartUp::report(const comm::Communicator& ranks) const {
  constexpr std::array<const char*, start_stages> names{"reading",      "ordering", "checking", "partitioning",
                                                        "distributing", "building", "opening"};
  std::array<double, start_stages> peak = peak_bytes_;
  ranks.max(peak);
  nlohmann::ordered_json report;
  for (std::size_t k = 0; k < start_stages; ++k)
    report[names[k]] = {{"seconds", seconds_[k]}, {"peak_bytes", static_cast<GlobalIndex>(peak[k])}};
  return report;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void release_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace brunt::app
