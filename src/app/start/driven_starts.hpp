// SPDX-License-Identifier: Apache-2.0
// Directions that `initial` and `prescribed` both move at t = 0.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// One line for each entry of `prescribed` whose velocity at t = 0 is not the initial one of a node or body that it
/// moves (time/driven_start.hpp). velocity: of `initial`, of each node. Collective; the same on all ranks.
[[nodiscard]] std::vector<std::string> driven_starts(const Prepared& run, std::span<const Vec3> velocity);

}  // namespace brunt::app
