// SPDX-License-Identifier: Apache-2.0
// When records are due, from the state alone, so that a restart finds the same steps.
#pragma once
#include <cmath>
#include <optional>

#include "brunt/model/model.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::app {

/// True at the first step at or past each multiple of `every` (t = 0 too).
inline bool due(const model::State& state, const std::optional<double>& every) {
  if (!every) return false;
  if (state.step == 0) return true;
  return std::floor(state.time / *every) > std::floor(state.time_before / *every);
}

/// True once the run has reached its end.
inline bool at_end(const model::State& state, const scene::Run& run) {
  return (run.end && state.time >= *run.end) || (run.steps && state.step >= static_cast<double>(*run.steps));
}

/// Share of the run that is done, 0..1.
inline double progress(const model::State& state, const scene::Run& run) {
  double share = 0;
  if (run.end) share = std::max(share, state.time / *run.end);
  if (run.steps) share = std::max(share, state.step / static_cast<double>(*run.steps));
  return std::min(share, 1.0);
}

}  // namespace brunt::app
