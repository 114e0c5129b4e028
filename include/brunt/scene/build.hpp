// SPDX-License-Identifier: Apache-2.0
// From what the scene says and this rank's piece of the mesh to the Model. Local to the rank.
#pragma once
#include "brunt/mesh/local_mesh.hpp"
#include "brunt/model/model.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::scene {

/// The mesh must have been through scene::select before it was distributed. Throws InputError for a node in two
/// incompatible constraints (both are named).
model::Model build_model(const Input& input, mesh::LocalMesh&& mesh);

/// What the scene wants where these two parts overlap at the start; none where they have no contact.
std::optional<ContactEntry::InitialOverlap> overlap_rule(const Input& input, const std::string& a,
                                                         const std::string& b);

/// Velocity of each local node at t = 0 [length/time].
std::vector<Vec3> initial_velocities(const Input& input, const model::Model& model);

}  // namespace brunt::scene
