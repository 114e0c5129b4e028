// SPDX-License-Identifier: Apache-2.0
// Prediction of the work of mortar contact, for the partition.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// Faces of the slaves of mortar interfaces that are closer to the bounding box of their master than the length of a
/// face, or all faces of a slave without such faces, since they may touch later. If the program chooses the slave, the
/// finer side is used. Ties count too, since their normals rotate. Empty without mortar contact.
std::vector<mesh::Side> mortar_slaves(const scene::Input& input, const mesh::Mesh& mesh);

}  // namespace brunt::app
