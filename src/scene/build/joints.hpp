// SPDX-License-Identifier: Apache-2.0
// Joints of rigid parts and supports at reference points: from the scene to the model.
#pragma once
#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// Model::joints: those of the scene, then the supports of bodies with a reference point.
void build_joints(const Input& input, model::Model& model);

}  // namespace brunt::scene
