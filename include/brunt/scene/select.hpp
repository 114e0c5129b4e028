// SPDX-License-Identifier: Apache-2.0
// Finds what the names of a scene mean in the whole mesh, before it is distributed: every entry of the scene that
// selects nodes or faces becomes a set of the mesh under a reserved name, so that ranks need no further look-up and
// a node that two ranks hold is selected on both.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/canonical.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::scene {

/// Reserved names: "@fixed:0" is what the first entry of `fixed` selects.
std::string selection_name(const std::string& kind, std::size_t entry);

/// All nodes of exterior faces: on every rank that holds the node, also where the face is another rank's.
constexpr const char* surface_set = "@surface";

/// Nodes that elements of several parts share; there where a probe asks for the energy of a part.
constexpr const char* interface_set = "@interface";

/// Position in `Input::parts` of the part of each block of the mesh. Throws InputError: part without block, block
/// without part, two parts on one block, element that does not fit the block's shape.
std::vector<std::size_t> parts_of_blocks(const Input& input, const mesh::Mesh& mesh);

/// Adds the reserved sets to the mesh. Throws InputError with all names that are unknown or select nothing.
void select(const Input& input, mesh::CanonicalMesh& whole);

/// A line for each probe `near` a place: which node it is, and how far from there. After `select`.
std::vector<std::string> nearest_nodes(const Input& input, const mesh::CanonicalMesh& whole);

}  // namespace brunt::scene
