// SPDX-License-Identifier: Apache-2.0
// Joints of rigid parts and supports at reference points: from the scene to the model.
#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// Joints of parts that are not rigid or that are one body, and scenes that have no joints in this version.
std::vector<std::string> faults_of_joints(const Input& input);

/// Model::joints: those of the scene, then the supports of bodies with a reference point.
void build_joints(const Input& input, model::Model& model);

}  // namespace brunt::scene
