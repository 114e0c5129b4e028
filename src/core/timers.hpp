// SPDX-License-Identifier: Apache-2.0
// Wall-clock seconds of the time loop on this rank, by phase.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>

#include "core/types.hpp"

namespace brunt {

enum class Phase { element, search, enforcement, halo, other, output };
constexpr std::size_t phases = 6;

class Timers {
 public:
  using Clock = std::chrono::steady_clock;

  /// Adds the time between its construction and its destruction to one phase.
  class Measure {
   public:
    Measure(Timers& timers, Phase phase) : timers_(timers), phase_(phase), start_(Clock::now()) {}
    ~Measure() { timers_.add(phase_, std::chrono::duration<double>(Clock::now() - start_).count()); }
    Measure(const Measure&) = delete;
    Measure& operator=(const Measure&) = delete;

   private:
    Timers& timers_;
    Phase phase_;
    Clock::time_point start_;
  };

  [[nodiscard]] Measure measure(Phase phase) { return Measure(*this, phase); }
  void add(Phase phase, double seconds) { nth(seconds_, phase) += seconds; }
  [[nodiscard]] double seconds(Phase phase) const { return nth(seconds_, phase); }

 private:
  std::array<double, phases> seconds_{};
};

}  // namespace brunt
