// SPDX-License-Identifier: Apache-2.0
// The bodies of a scene's mesh: generated or read, put in their places, checked, joined.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::app {

/// All bodies in one mesh. Throws InputError with the faults of all of them; `warnings` gets what a user should know.
mesh::Mesh assemble(const scene::Input& input, std::vector<std::string>& warnings);

/// One line for each round body that is generated, by how far its mesh differs from the exact body; a warning where its
/// volume differs by more than 1 %, or its centre lies off by more than 1 % of its radius.
struct RoundBodies {
  std::vector<std::string> lines, warnings;
};
RoundBodies round_bodies(const scene::Input& input);

/// One line for each block of the files that is left out, and for each set that lost something by it.
std::vector<std::string> left_out_lines(const mesh::Mesh& mesh);

}  // namespace brunt::app
