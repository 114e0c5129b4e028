// SPDX-License-Identifier: Apache-2.0
// Time before the first step, and growth of memory by stage.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "comm/communicator.hpp"

namespace brunt::app {

/// In this order; the first four are executed by the root only, while the other ranks wait.
enum class StartStage {
  reading,       ///< the scene; its mesh files read or bodies generated, and checked
  ordering,      ///< the canonical order, and what the scene selects
  checking,      ///< overlaps at the start, slaves
  partitioning,  ///< which rank computes which element
  distributing,  ///< pieces of the mesh cut and sent
  building,      ///< model, state and contact of each rank
  opening        ///< a checkpoint read, result files opened
};
constexpr std::size_t start_stages = 7;

class StartUp {
 public:
  /// Ends a stage, which began at the end of the previous one.
  void end(StartStage stage);

  /// By stage: seconds of the root, and the largest resident memory of any rank up to the end of the stage. Collective.
  [[nodiscard]] nlohmann::ordered_json report(const comm::Communicator& ranks) const;

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  std::array<double, start_stages> seconds_{}, peak_bytes_{};
};

/// Largest resident memory of this process so far [bytes].
[[nodiscard]] double peak_memory();

/// Returns freed memory to the system, which would otherwise keep it for later allocations.
void release_freed_memory();

}  // namespace brunt::app
