// SPDX-License-Identifier: Apache-2.0
// Where the time of implicit steps goes.
#pragma once
#include <chrono>

namespace brunt::implicit {

/// Adds the time of its life to an account [s].
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
