// SPDX-License-Identifier: Apache-2.0
// Of parts that overlap at the start: the smallest rigid motion that separates them.
#pragma once
#include <string>
#include <vector>

#include "brunt/scene/input.hpp"

namespace brunt::app {

/// A line for each pair of parts that overlap: the shortest translation of the lighter one in directions in which it is
/// not held, or of the other one where the lighter is held in some way and the other needs less; the shortest motion in
/// the displacement metric where that is shorter and the part is held in no way; and below which length no motion
/// separates them (proven). Pairs that move as one (shared nodes, ties, a common rigid body) are left out. The mesh is
/// assembled anew: as it was before anything was moved. On the root.
[[nodiscard]] std::vector<std::string> smallest_motions(const scene::Input& input);

}  // namespace brunt::app
