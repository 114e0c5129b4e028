// SPDX-License-Identifier: Apache-2.0
// The bodies of a scene's mesh: generated or read, placed, checked and assembled.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// All bodies in one mesh. Throws InputError with the faults of all of them; `warnings` receives warnings for the user.
mesh::Mesh assemble(const scene::Input& input, std::vector<std::string>& warnings);

/// One line for each generated round body, with the difference between its mesh and the exact body; a warning if its
/// volume differs by more than 1 %, or its centre by more than 1 % of its radius.
struct RoundBodies {
  std::vector<std::string> lines, warnings;
};
RoundBodies round_bodies(const scene::Input& input);

/// One line for each excluded block of the files, and for each set that lost members.
std::vector<std::string> left_out_lines(const mesh::Mesh& mesh);

}  // namespace brunt::app
