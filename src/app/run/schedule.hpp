// SPDX-License-Identifier: Apache-2.0
// Times of records, determined from the state only, so that a restart gives the same steps.
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// True at the first step at or after each multiple of `every` (including t = 0). slack: the share of `every` by which
/// a step may miss it.
inline bool due(const model::State& state, const std::optional<double>& every, double slack = 0) {
  if (!every) return false;
  if (state.step == 0) return true;
  return std::floor(state.time / *every + slack) > std::floor(state.time_before / *every + slack);
}

/// Steps of implicit runs have the user's length: they meet given times up to rounding.
constexpr double implicit_slack = 1e-9;

/// True where history is to have a row: as the scene says, else some 200 over the run, but five steps apart at least (a
/// row of a large model costs as much as a step).
inline bool history_due(const model::State& state, const scene::Input& input) {
  constexpr double rows = 200, least_steps = 5;
  if (input.history_every) return due(state, input.history_every);
  const scene::Run& run = input.run;
  const bool by_time = run.end && due(state, std::max(*run.end / rows, least_steps * (state.time - state.time_before)));
  return by_time ||
         (run.steps &&
          std::fmod(state.step, std::max(least_steps, std::floor(static_cast<double>(*run.steps) / rows))) == 0);
}

/// The same in implicit runs, whose steps are long: every one has a row, unless the scene says otherwise.
inline bool implicit_row_due(const model::State& state, const scene::Input& input) {
  return !input.history_every || due(state, input.history_every, implicit_slack);
}

/// Time after the end of the run, as a share of it.
inline double overshoot(const model::State& state, const scene::Run& run) {
  return run.end ? std::max(0.0, state.time / *run.end - 1) : 0;
}

/// True once the run has reached its end. slack: a share of it by which a step may miss it.
inline bool at_end(const model::State& state, const scene::Run& run, double slack = 0) {
  return (run.end && state.time >= (1 - slack) * *run.end) ||
         (run.steps && state.step >= static_cast<double>(*run.steps));
}

/// Share of the run that is done, 0..1.
inline double progress(const model::State& state, const scene::Run& run) {
  double share = 0;
  if (run.end) share = std::max(share, state.time / *run.end);
  if (run.steps) share = std::max(share, state.step / static_cast<double>(*run.steps));
  return std::min(share, 1.0);
}

/// Time that the rest of the run will take at the speed since it (or its restart) began at the share `first` [s].
inline double seconds_left(double elapsed, double first, double share) {
  return share > first ? elapsed * (1 - share) / (share - first) : 0;
}

}  // namespace brunt::app
