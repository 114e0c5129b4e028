// SPDX-License-Identifier: Apache-2.0
// What a scene makes of its mesh, in lines for `brunt check`: bodies, sets, motions, supports and loads, with the
// numbers of nodes and faces that they select.
#pragma once
#include <string>
#include <vector>

#include "prepare.hpp"

namespace brunt::app {

/// Lines "kind   what it is". Collective; the same on all ranks.
std::vector<std::string> list_scene(const Prepared& run);

}  // namespace brunt::app
