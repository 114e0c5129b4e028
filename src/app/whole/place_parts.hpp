// SPDX-License-Identifier: Apache-2.0
// initial_overlap: place - whole parts are moved apart as rigid bodies at the start of the set-up.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/input.hpp"
#include "setup/initial_gaps.hpp"
#include "setup/start_rules.hpp"

namespace brunt::app {

struct PlacedParts {
  std::vector<std::string> notes;     ///< a line for all, then one for each part that moved
  std::vector<std::string> warnings;  ///< of a part that a limit lets move far beyond its overlaps, see placed_far.hpp
  std::vector<std::string> faults;    ///< why it failed; the mesh is then unchanged
};

/// Moves the coordinates of parts by the smallest sum of mass times object norm squared (depth/assembly.hpp) for which
/// no pair with the rule `place` or `error` overlaps. Parts that only touch are separated by the clearance of 1e-8 of
/// the largest radius. Sets have been selected before. Rigid walls, and planes of symmetry for parts without nodes in
/// them, are not considered: see placed_beyond.hpp. gaps: of the mesh as it is given; parts that would leave the parts
/// that they overlap are a fault, see placed_far.hpp.
[[nodiscard]] PlacedParts place_parts(const scene::Input& input, mesh::Mesh& mesh, const setup::StartRules& rules,
                                      const setup::InitialGaps& gaps);

}  // namespace brunt::app
