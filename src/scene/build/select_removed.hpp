// SPDX-License-Identifier: Apache-2.0
// Elements that a scene removes: those of a part, or those with all their nodes in a set.
#pragma once
#include <string>
#include <vector>

#include "mesh/canonical.hpp"
#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// Creates the side set mesh::inner_faces: shared faces whose nodes all belong to removed elements. Call it after the
/// node sets of the removals exist. Returns the faults of these: a rigid part, a set without elements.
std::vector<std::string> select_removed(const Input& input, mesh::CanonicalMesh& whole);

/// The removals of the scene, by time, and the nodes that they may leave without elements.
void build_removals(const Input& input, model::Model& model);

}  // namespace brunt::scene
