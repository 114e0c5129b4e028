// SPDX-License-Identifier: Apache-2.0
// Where mortar contact will have its work, for the split over the ranks.
#pragma once
#include <vector>

#include "brunt/mesh/mesh.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::app {

/// Faces of the slaves of mortar interfaces that are nearer to the box around their master than a face is long, or all
/// of a slave of which none is: they may meet later. Of sides that the scene leaves to the program the finer is the
/// slave. Ties count too, whose normals turn. None without mortar contact.
std::vector<mesh::Side> mortar_slaves(const scene::Input& input, const mesh::Mesh& mesh);

}  // namespace brunt::app
