// SPDX-License-Identifier: Apache-2.0
// Wall time of the parts of implicit steps.
#pragma once
#include <chrono>

namespace brunt::implicit {

/// Adds the time of its lifetime to an account [s].
class Measure {
 public:
  explicit Measure(double& account) : account_(account) {}
  Measure(const Measure&) = delete;
  Measure& operator=(const Measure&) = delete;
  ~Measure() { account_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& account_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace brunt::implicit
