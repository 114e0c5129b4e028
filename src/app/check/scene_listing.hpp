// SPDX-License-Identifier: Apache-2.0
// The scene applied to its mesh, in lines for `brunt check`: bodies, sets, motions, supports and loads, with the
// numbers of selected nodes and faces.
#pragma once
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// Lines "kind   what it is". Collective; the same on all ranks.
std::vector<std::string> list_scene(const Prepared& run);

}  // namespace brunt::app
