// SPDX-License-Identifier: Apache-2.0
#include "time/removal.hpp"

#include <algorithm>

#include "model/alive.hpp"
#include "surface/exposed.hpp"

namespace brunt::time {
namespace {

/// The first step at or after the time of a removal; it depends only on the times of the state, so that a restart finds
/// the same step.
bool is_due(const model::Removal& removal, const model::State& state) {
  return removal.at <= state.time && removal.at > state.time_before;
}

}  // namespace

bool removal_is_due(const model::Model& model, const model::State& state) {
  return std::ranges::any_of(model.losses.removals,
                             [&](const model::Removal& removal) { return is_due(removal, state); });
}

void follow_alive(const comm::Communicator& ranks, const model::Model& model, model::State& state) {
  state.living = model::follow(model, state);
  if (!state.alive.empty()) state.living.dropped = surface::bare_nodes(ranks, model.mesh, state.alive).dropped;
  for (const LocalIndex node : state.living.dropped) nth(state.nodes, node).deferred = model::NodeLine::dropped;
}

std::vector<GlobalIndex> remove_elements(const comm::Communicator& ranks, const model::Model& model,
                                         model::State& state) {
  std::vector<GlobalIndex> lost(model.blocks.size(), 0);
  for (const model::Removal& removal : model.losses.removals) {
    if (!is_due(removal, state)) continue;
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
      for (const LocalIndex element : removal.elements[b]) {
        double& alive = nth(state.alive[b], element);
        if (alive > 0) {
          ++lost[b];
          alive = removal.keeps_nodes ? 0 : -1;
        }
      }
  }
  follow_alive(ranks, model, state);
  ranks.sum(lost);
  return lost;
}

GlobalIndex removed_elements(const comm::Communicator& ranks, const model::State& state) {
  GlobalIndex removed = 0;
  for (const std::vector<double>& alive : state.alive)
    removed += std::ranges::count_if(alive, [](double flag) { return flag <= 0; });
  return ranks.sum(removed);
}

}  // namespace brunt::time
