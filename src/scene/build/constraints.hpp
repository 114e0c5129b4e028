// SPDX-License-Identifier: Apache-2.0
// Converts fixed, symmetric and prescribed nodes to projectors onto their free directions.
#pragma once
#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// Fills Model::supports and Model::rotation_supports; drives of both are in the former. Throws InputError for a node
/// in two incompatible entries.
void build_constraints(const Input& input, model::Model& model);

}  // namespace brunt::scene
