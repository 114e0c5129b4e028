// SPDX-License-Identifier: Apache-2.0
// Builds the Model from the scene and this rank's piece of the mesh. Not collective.
#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/local_mesh.hpp"
#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// The mesh must have passed scene::select before it was distributed. part_of: of each block, from parts_of_blocks.
/// Throws InputError for a node with two incompatible constraints (the message names both).
model::Model build_model(const Input& input, std::span<const std::size_t> part_of, mesh::LocalMesh&& mesh);

/// A flag for each face: true if all its nodes lie in a plane of symmetry. Such a face is inside the complete body, so
/// nothing can touch it.
std::vector<char> in_symmetry_plane(const Input& input, const mesh::LocalMesh& mesh,
                                    std::span<const mesh::ExteriorFace> faces);

/// Position in `contact` of the entry that applies to two parts; none if they have no contact. Tied parts remain tied
/// under later entries with `all`.
std::optional<std::size_t> deciding_entry(const Input& input, const std::string& a, const std::string& b);

/// The key path of this entry, "contact.1"; "contact" if there is none.
std::string contact_key(const Input& input, const std::string& a, const std::string& b);

/// The rule for an initial overlap of these two parts; none if they have no contact.
std::optional<contact::OverlapRule> overlap_rule(const Input& input, const std::string& a, const std::string& b);

/// The contact settings for each pair of blocks; for a pair of parts a later entry takes precedence. part_of_block:
/// names.
contact::Specification contact_specification(const Input& input, std::span<const std::string> part_of_block);

using NodeSets = std::map<std::string, std::vector<LocalIndex>>;

/// Velocity of each node at t = 0 [length/time]. coordinates: relative to `origin`; sets: with those of scene::select.
std::vector<Vec3> initial_velocities(const Input& input, std::span<const Vec3> coordinates, const Vec3& origin,
                                     const NodeSets& sets);

/// The same for the local nodes of a rank.
std::vector<Vec3> initial_velocities(const Input& input, const model::Model& model);

/// Of rotation, of nodes of shells; by node [1/time]; empty without shells.
std::vector<Vec3> initial_rates(const Input& input, const model::Model& model);

}  // namespace brunt::scene
