// SPDX-License-Identifier: Apache-2.0
// Parts that are rigid bodies: from the scene to the model.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "mesh/canonical.hpp"
#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

[[nodiscard]] bool is_rigid(const Input& input, const Part& part);

/// Whether this is the name of a rigid part.
[[nodiscard]] bool names_rigid_part(const Input& input, const std::string& where);

/// The part that names the body of this rigid part: itself, or the one that it joins.
[[nodiscard]] const std::string& lead_of(const Input& input, const std::string& part);

/// Whether these two rigid parts (or one given twice) form one body.
[[nodiscard]] bool are_one_body(const Input& input, const std::string& a, const std::string& b);

/// On the whole mesh, after the selections: adds the sets below and returns the faults (constrained nodes of rigid
/// parts, nodes of two rigid parts).
[[nodiscard]] std::vector<std::string> select_bodies(const Input& input, std::span<const std::string> part_of_block,
                                                     mesh::CanonicalMesh& whole);

/// Nodes of a rigid part, on every rank that holds the node, even if the element is on another rank.
std::string body_set(std::size_t block);
/// Nodes of rigid parts on which deformable elements or loads act.
constexpr const char* forced_set = "@forced";
/// Nodes of the rigid parts whose motion this entry of `initial` defines: it selects all their nodes.
std::string body_motion_set(std::size_t initial_entry);

/// The local nodes of all rigid parts.
[[nodiscard]] std::vector<LocalIndex> rigid_nodes(const mesh::LocalMesh& mesh);

/// The rigid bodies of the scene as known to this rank; time::link_bodies completes them over the ranks.
void build_bodies(const Input& input, model::Model& model);

}  // namespace brunt::scene
