// SPDX-License-Identifier: Apache-2.0
// The parts of a scene as rigid bodies that may be placed: what moves as one, what is held, what must not overlap.
//
// Parts are one member where they share nodes, are tied, or are one rigid body. A member may move if one of its parts
// takes part in a pair with `initial_overlap: place`. A direction in which a node of it is held (fixed, symmetry,
// prescribed) is held for all of it, and with any held node it does not turn. A rigid body whose centre of mass the
// scene gives stays, one whose inertia it gives does not turn.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "brunt/depth/assembly.hpp"
#include "brunt/scene/input.hpp"
#include "brunt/setup/start_rules.hpp"

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

/// What the scene lets each member do, whatever its contact: only `basis` and `turns` of the members tell anything.
[[nodiscard]] std::vector<depth::Member> freedoms_of_members(const scene::Input& input, const mesh::Mesh& mesh,
                                                             const std::vector<std::size_t>& member_of);

/// The body of a block. Throws InputError if its surface is not closed; `who` begins the message.
[[nodiscard]] depth::Body body_of_block(const mesh::Mesh& mesh, std::size_t block, const std::string& who);

[[nodiscard]] SceneAssembly scene_assembly(const scene::Input& input, const mesh::Mesh& mesh,
                                           const setup::StartRules& rules);

}  // namespace brunt::app
