// SPDX-License-Identifier: Apache-2.0
// Free poses of an assembly from which walks may start.
#pragma once
#include <optional>
#include <vector>

#include "assembly_pose.hpp"

namespace brunt::depth {

/// Translations only. Of each overlapping pair the shortest translation that separates it, along u by d, gives the
/// condition u . (x_a - x_b) >= d, relative to where it was asked; the least translations under all conditions follow
/// from one quadratic program, and pairs that overlap there are asked next. Where conditions exclude each other, a pair
/// among them has to leave in a direction across u. None: no free pose was found, `stuck` lists pairs then.
[[nodiscard]] std::optional<Pose> start_by_planes(const Standing& standing, double margin,
                                                  std::vector<std::size_t>& stuck);

/// Pair by pair in turn, the least motion in the object norm, along its screw shared in the ratio of the other's mass;
/// bodies that may not move in all ways are translated.
[[nodiscard]] std::optional<Pose> start_by_pairs(const Standing& standing, double margin);

/// All members that may move away from their common centre.
[[nodiscard]] std::optional<Pose> start_by_expansion(const Standing& standing);

}  // namespace brunt::depth
