// SPDX-License-Identifier: Apache-2.0
// Duplicate elements: their mass and stiffness would be counted twice without a visible effect on the motion.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

/// One line for each element with the nodes of an earlier one, in any order and block. A hexahedron that is collapsed
/// to a tetrahedron equals the tetrahedron of its nodes.
std::vector<std::string> duplicate_elements(const Mesh& mesh);

/// One line for each pair of blocks of different `piece` (a number for each block) whose elements have all corners at
/// the same positions, to 1e-6 of the element's size. The rounding of coordinates is at most 2^-22 = 2.4e-7 of it (see
/// `largest_to_smallest` in mesh/resolution.hpp).
std::vector<std::string> coincident_elements(const Mesh& mesh, const std::vector<int>& piece);

}  // namespace brunt::mesh
