// SPDX-License-Identifier: Apache-2.0
// Messages if initial_overlap: move fails.
#pragma once
#include <string>
#include <vector>

#include "scene/input.hpp"
#include "setup/move_overlaps.hpp"

namespace brunt::app {

/// Empty if the moves succeeded. held: the scene's key of each list of constrained nodes.
std::vector<std::string> report_refused_moves(const scene::Input& input, const mesh::Mesh& mesh,
                                              const std::vector<std::string>& held, const setup::OverlapMoves& moves);

}  // namespace brunt::app
