// SPDX-License-Identifier: Apache-2.0
// initial_overlap: place - whole parts move apart as rigid bodies before anything else sees the mesh.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"
#include "brunt/scene/input.hpp"
#include "brunt/setup/start_rules.hpp"

namespace brunt::app {

struct PlacedParts {
  std::vector<std::string> notes;   ///< a line for all, then one for each part that moved
  std::vector<std::string> faults;  ///< why it cannot be done; the mesh is as it was then
};

/// Moves the coordinates of parts by the least sum of mass times object norm squared (depth/assembly.hpp) so that no
/// pair with the rule `place` or `error` overlaps. Parts that only touch are parted by the clearance of 1e-8 of the
/// largest radius. Sets have been chosen before. Rigid walls, and planes of symmetry for parts that have no node in
/// them, are not looked at: see placed_beyond.hpp.
[[nodiscard]] PlacedParts place_parts(const scene::Input& input, mesh::Mesh& mesh, const setup::StartRules& rules);

}  // namespace brunt::app
