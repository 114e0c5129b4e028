// SPDX-License-Identifier: Apache-2.0
// The parts of a scene as rigid bodies that may be placed: which move as one, which are constrained, and which must not
// overlap.
//
// Parts are one member if they share nodes, are tied, or are one rigid body. A member may move if one of its parts
// belongs to a pair with `initial_overlap: place`. A direction in which one of its nodes is constrained (fixed,
// symmetry, prescribed) is constrained for the whole member, and with any constrained node it does not rotate. A rigid
// body with a given centre of mass does not move, one with a given inertia does not rotate.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "depth/assembly.hpp"
#include "scene/input.hpp"
#include "setup/start_rules.hpp"

namespace brunt::app {

struct SceneAssembly {
  std::vector<std::unique_ptr<depth::Body>> bodies;  ///< of each block; none where it meets nothing that may move
  depth::Assembly assembly;
  std::vector<std::vector<std::size_t>> blocks;  ///< of each member, ascending: surface s is that of block s
  std::vector<std::string> faults;               ///< surfaces that are not closed
};

/// Of each block the number of its member, from 0 in the order of the first blocks.
[[nodiscard]] std::vector<std::size_t> members_of_blocks(const scene::Input& input, const mesh::Mesh& mesh,
                                                         const setup::StartRules& rules);

/// The admissible motions of each member, independent of contact: only `basis` and `turns` of the members are used.
[[nodiscard]] std::vector<depth::Member> freedoms_of_members(const scene::Input& input, const mesh::Mesh& mesh,
                                                             const std::vector<std::size_t>& member_of);

/// The body of a block. Throws InputError if its surface is not closed; `who` begins the message.
[[nodiscard]] depth::Body body_of_block(const mesh::Mesh& mesh, std::size_t block, const std::string& who);

[[nodiscard]] SceneAssembly scene_assembly(const scene::Input& input, const mesh::Mesh& mesh,
                                           const setup::StartRules& rules);

}  // namespace brunt::app
