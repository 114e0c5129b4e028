// SPDX-License-Identifier: Apache-2.0
// Fixed, symmetric and prescribed nodes become projectors on what is left free.
#pragma once
#include "brunt/model/model.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::scene {

/// Fills Model::constrained and Model::drives. Throws InputError where a node is in two incompatible entries.
void build_constraints(const Input& input, model::Model& model);

}  // namespace brunt::scene
