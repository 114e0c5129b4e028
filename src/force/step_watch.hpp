// SPDX-License-Identifier: Apache-2.0
// Data that the loop over elements stores for bounds of the assembled mesh (force/assembled.hpp).
#pragma once
#include <algorithm>

#include "element/batch.hpp"
#include "force/assembled.hpp"
#include "living.hpp"

namespace brunt::force {

/// Of one block; null if not required.
struct WatchedBlock {
  const Pack* baseline = nullptr;
  Pack* linear = nullptr;
};

inline WatchedBlock watched_block(const StepWatch& watch, LocalIndex block) {
  const auto b = static_cast<std::size_t>(block);
  WatchedBlock watched;
  if (b < watch.baseline.size()) watched.baseline = reinterpret_cast<const Pack*>(watch.baseline[b].data());
  if (b < watch.linear.size()) watched.linear = reinterpret_cast<Pack*>(watch.linear[b].data());
  return watched;
}

template <int nodes>
BRUNT_INLINE void keep_linear(const element::BatchForce<nodes>& out, Pack* linear) {
  const element::BatchStiffness& now = out.stiffness;
  linear[at_lambda] = pack_max(now.lambda, broadcast(0.0));
  linear[at_mu] = now.mu;
  linear[at_viscosity] = now.viscosity;
  linear[at_spring] = now.spring;
  linear[at_dashpot] = now.dashpot;
  linear[at_plane2] = now.plane2;
  linear[at_rate] = out.rate;
}

/// Collapsed elements in a block that deletes them have no rate (see keep_bounds) and are ignored.
template <int nodes>
BRUNT_INLINE void see_growth(const element::BatchForce<nodes>& out, const Pack* baseline, int lanes,
                             std::uint8_t living, double& largest) {
  const Pack growth = pack_max(out.rate * out.rate * baseline[0], out.stiffness.plane2 * baseline[1]);
  if (!any(growth > largest)) return;
  for (int lane = 0; lane < lanes; ++lane)
    if (lives(living, lane) && out.rate[lane] > 0) largest = std::max(largest, growth[lane]);
}

}  // namespace brunt::force
