// SPDX-License-Identifier: Apache-2.0
// What the user is told where initial_overlap: move cannot be done.
#pragma once
#include <string>
#include <vector>

#include "brunt/scene/input.hpp"
#include "brunt/setup/move_overlaps.hpp"

namespace brunt::app {

/// None where the moves were done. held: the scene's key of each list of held nodes.
std::vector<std::string> report_refused_moves(const scene::Input& input, const mesh::Mesh& mesh,
                                              const std::vector<std::string>& held, const setup::OverlapMoves& moves);

}  // namespace brunt::app
