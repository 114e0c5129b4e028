// SPDX-License-Identifier: Apache-2.0
// Where a body is put: the keys scale, rotate and at.
#pragma once
#include <vector>

#include "scene/input.hpp"
#include "scene/keys/table.hpp"

namespace brunt::scene {

/// Rows of a rotation about an axis.
std::vector<Row<Rotation>> rotation_rows();
std::vector<Row<Placement>> placement_rows();

}  // namespace brunt::scene
