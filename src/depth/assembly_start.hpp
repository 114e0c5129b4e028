// SPDX-License-Identifier: Apache-2.0
// Free poses of an assembly as starts of walks.
#pragma once
#include <optional>
#include <vector>

#include "assembly_pose.hpp"

namespace brunt::depth {

/// Translations only. For each overlapping pair the shortest separating translation, along u by d, gives the condition
/// u . (x_a - x_b) >= d, relative to its current position. The least translations under all conditions follow from one
/// quadratic program, and pairs that overlap there add conditions. If conditions are contradictory, one of their pairs
/// must separate in a direction perpendicular to u. None: no free pose was found; `stuck` then lists pairs.
[[nodiscard]] std::optional<Pose> start_by_planes(const Standing& standing, double margin,
                                                  std::vector<std::size_t>& stuck);

/// Pair by pair, the least motion in the object norm, along its screw, divided in the inverse ratio of the masses;
/// bodies with restricted motion are translated.
[[nodiscard]] std::optional<Pose> start_by_pairs(const Standing& standing, double margin);

/// All movable members away from their common centre.
[[nodiscard]] std::optional<Pose> start_by_expansion(const Standing& standing);

}  // namespace brunt::depth
