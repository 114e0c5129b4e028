// SPDX-License-Identifier: Apache-2.0
// Rigid walls and planes of symmetry that initial_overlap: place does not consider.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// A warning for each part that stands farther behind a rigid wall that acts on it, or farther across a plane of
/// symmetry, than it did. before: coordinates of all nodes of the mesh before parts were placed [length].
[[nodiscard]] std::vector<std::string> placed_beyond(const scene::Input& input, const mesh::Mesh& mesh,
                                                     std::span<const Vec3> before);

}  // namespace brunt::app
