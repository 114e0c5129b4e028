// SPDX-License-Identifier: Apache-2.0
// From what the scene says and this rank's piece of the mesh to the Model. Local to the rank.
#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brunt/mesh/local_mesh.hpp"
#include "brunt/model/model.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::scene {

/// The mesh must have been through scene::select before it was distributed. Throws InputError for a node in two
/// incompatible constraints (both are named).
model::Model build_model(const Input& input, mesh::LocalMesh&& mesh);

/// A flag for each face: do all its nodes lie in a plane of symmetry? Such faces are inside the whole body: nothing can
/// touch them.
std::vector<char> in_symmetry_plane(const Input& input, const mesh::LocalMesh& mesh,
                                    std::span<const mesh::ExteriorFace> faces);

/// Position in `contact` of the entry that holds for two parts; none where they have no contact. Tied parts stay so
/// under later entries with `all`.
std::optional<std::size_t> deciding_entry(const Input& input, const std::string& a, const std::string& b);

/// Its key path, "contact.1"; "contact" where there is none.
std::string contact_key(const Input& input, const std::string& a, const std::string& b);

/// What the scene wants where these two parts overlap at the start; none where they have no contact.
std::optional<contact::OverlapRule> overlap_rule(const Input& input, const std::string& a, const std::string& b);

/// What contact is asked for, by pairs of blocks; a later entry wins for a pair of parts. part_of_block: names.
contact::Specification contact_specification(const Input& input, std::span<const std::string> part_of_block);

using NodeSets = std::map<std::string, std::vector<LocalIndex>>;

/// Velocity of each node at t = 0 [length/time]. coordinates: less `origin`; sets: with those of scene::select.
std::vector<Vec3> initial_velocities(const Input& input, std::span<const Vec3> coordinates, const Vec3& origin,
                                     const NodeSets& sets);

/// The same of a rank's local nodes.
std::vector<Vec3> initial_velocities(const Input& input, const model::Model& model);

}  // namespace brunt::scene
