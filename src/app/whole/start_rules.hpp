// SPDX-License-Identifier: Apache-2.0
// From the scene to the rules for the initial geometry (room setup).
#pragma once
#include <string>
#include <vector>

#include "mesh/canonical.hpp"
#include "scene/input.hpp"
#include "setup/likely_slaves.hpp"
#include "setup/move_overlaps.hpp"
#include "setup/start_rules.hpp"

namespace brunt::app {

/// Settings of contact for the blocks of a mesh, in their order.
struct BlockMaterials {
  std::vector<std::string> part;
  std::vector<double> density;  ///< [mass/length^3]
};
BlockMaterials block_materials(const scene::Input& input, const mesh::Mesh& mesh);

/// mesh: with the selections of the scene, where it has planes of symmetry.
setup::StartRules start_rules(const scene::Input& input, const mesh::Mesh& mesh);

/// Initial motion of the nodes, and its duration.
struct FirstMotion {
  std::vector<Vec3> velocity;  ///< of each node [length/time]
  double duration = 0;         ///< of the run [time]; infinite where only its steps are given
};
FirstMotion first_motion(const scene::Input& input, const mesh::CanonicalMesh& whole);

/// Constrained nodes, and the entry that constrains them: "fixed.0". mesh: with the selections of the scene; it must
/// outlive the result.
struct HeldByScene {
  std::vector<setup::HeldNodes> nodes;
  std::vector<std::string> key;
};
HeldByScene held_nodes(const scene::Input& input, const mesh::Mesh& mesh);

}  // namespace brunt::app
