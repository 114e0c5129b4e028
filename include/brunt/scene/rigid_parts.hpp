// SPDX-License-Identifier: Apache-2.0
// Parts that are rigid bodies: what a scene says of them, from its text to the model.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "brunt/mesh/canonical.hpp"
#include "brunt/model/model.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::scene {

[[nodiscard]] bool is_rigid(const Input& input, const Part& part);

/// Is this the name of a rigid part?
[[nodiscard]] bool names_rigid_part(const Input& input, const std::string& where);

/// The part whose name the body has that this rigid part belongs to: itself, or the one that it joins.
[[nodiscard]] const std::string& lead_of(const Input& input, const std::string& part);

/// Are these two rigid parts, or one twice, of one body?
[[nodiscard]] bool are_one_body(const Input& input, const std::string& a, const std::string& b);

/// Faults of parts that join others, and of what the scene says of a joined part that is its body's to do.
void check_joins(const Input& input, std::vector<std::string>& faults);

/// Faults that show without the mesh, "FILE:LINE: key: what": rotations of nodes, mass properties of a part that is not
/// rigid, no step where nothing gives one.
[[nodiscard]] std::vector<std::string> faults_of_rigid_parts(const Input& input);

/// On the whole mesh, after the selections: adds the sets below and returns the faults (nodes of rigid parts that are
/// held by themselves, nodes of two rigid parts).
[[nodiscard]] std::vector<std::string> select_bodies(const Input& input, std::span<const std::string> part_of_block,
                                                     mesh::CanonicalMesh& whole);

/// Nodes of a rigid part, on every rank that holds the node, also where the element is another rank's.
std::string body_set(std::size_t block);
/// Nodes of rigid parts that deformable elements or loads act on.
constexpr const char* forced_set = "@forced";
/// Nodes of the rigid parts of which this entry of `initial` gives the motion: it selects all of their nodes.
std::string body_motion_set(std::size_t initial_entry);

/// This rank's nodes of all rigid parts.
[[nodiscard]] std::vector<LocalIndex> rigid_nodes(const mesh::LocalMesh& mesh);

/// The rigid bodies of the scene as this rank knows them; the ranks complete each other in time::link_bodies.
void build_bodies(const Input& input, model::Model& model);

}  // namespace brunt::scene
