// SPDX-License-Identifier: Apache-2.0
// Whether two meshes are the same for a run that continues.
#pragma once
#include <string>

#include "mesh/canonical.hpp"

namespace brunt::app {

/// Sixteen hexadecimal digits of all that a run takes from its mesh: coordinates, blocks, sets of the mesh, and the
/// order and numbers of the input. Selections of the scene (names that begin with '@') follow from these and from the
/// scene. No protection against forgery.
[[nodiscard]] std::string mesh_digits(const mesh::CanonicalMesh& whole);

}  // namespace brunt::app
