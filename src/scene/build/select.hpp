// SPDX-License-Identifier: Apache-2.0
// Resolves the names of a scene in the whole mesh, before it is distributed. Every selection of nodes or faces becomes
// a set of the mesh under a reserved name. Ranks then need no look-up, and a node that two ranks hold is selected on
// both.
#pragma once
#include <string>
#include <vector>

#include "mesh/canonical.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// Reserved names: "@fixed:0" is the selection of the first entry of `fixed`.
std::string selection_name(const std::string& kind, std::size_t entry);

/// All nodes of exterior faces, on every rank that holds the node, even if the face is on another rank.
constexpr const char* surface_set = "@surface";

/// Nodes shared by elements of several parts; present if a probe records the energy of a part.
constexpr const char* interface_set = "@interface";

/// The element of a part whose block has elements of this shape: the given one, or hex8, shell4 or shell3.
element::ElementKind kind_of(const Part& part, mesh::Shape shape);

/// Position in `Input::parts` of the part of each block of the mesh. Throws InputError for a part without a block, a
/// block without a part, two parts of one block, an element that does not fit the shape of the block, or a part of
/// shells without a thickness.
std::vector<std::size_t> parts_of_blocks(const Input& input, const mesh::Mesh& mesh);

/// Adds the reserved sets to the mesh. Throws InputError with all names that are unknown or select nothing.
void select(const Input& input, mesh::CanonicalMesh& whole);

/// A line for each probe `near` a point: the node, and its distance from the point. Call it after `select`.
std::vector<std::string> nearest_nodes(const Input& input, const mesh::CanonicalMesh& whole);

}  // namespace brunt::scene
