// SPDX-License-Identifier: Apache-2.0
// What the elements of a scene cost, for the split over the ranks.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/canonical.hpp"
#include "brunt/scene/input.hpp"
#include "partition/split.hpp"

namespace brunt::app {

/// Costs of the elements and their faces that will bring contact its work (none without contact between parts: rows
/// of walls cost little). whole: with the selections of the scene.
partition::Weights weigh(const scene::Input& input, const mesh::CanonicalMesh& whole);

/// What contact is told of the blocks of a mesh, in their order.
struct BlockMaterials {
  std::vector<std::string> part;
  std::vector<double> density;  ///< [mass/length^3]
};
BlockMaterials block_materials(const scene::Input& input, const mesh::Mesh& mesh);

/// Exterior faces but for those in planes of symmetry. mesh: with the selections of the scene.
std::vector<mesh::Side> contact_faces(const scene::Input& input, const mesh::Mesh& mesh);

}  // namespace brunt::app
