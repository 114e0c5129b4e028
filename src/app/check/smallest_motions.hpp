// SPDX-License-Identifier: Apache-2.0
// The smallest rigid motion that separates initially overlapping parts.
#pragma once
#include <string>
#include <vector>

#include "scene/input.hpp"

namespace brunt::app {

/// A line for each pair of overlapping parts: the shortest translation of the lighter part in its free directions, or
/// of the other one if the lighter is constrained and the other one needs less; the shortest motion in the displacement
/// metric if that is shorter and the part is free; and the length below which no motion separates them (proven). Pairs
/// that move as one (shared nodes, ties, a common rigid body) are omitted. The mesh is assembled anew, as before any
/// treatment of overlaps. On the root.
[[nodiscard]] std::vector<std::string> smallest_motions(const scene::Input& input);

}  // namespace brunt::app
