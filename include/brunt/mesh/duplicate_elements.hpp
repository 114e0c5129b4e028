// SPDX-License-Identifier: Apache-2.0
// Elements that are there twice: their mass and stiffness would count twice, and nothing of the motion would show it.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::mesh {

/// One line for each element that has the nodes of an earlier one, in whatever order and block; a hexahedron that is
/// collapsed to a tetrahedron is one with the tetrahedron of its nodes.
std::vector<std::string> duplicate_elements(const Mesh& mesh);

/// One line for each pair of blocks of different `piece` (a number for each block) of which elements have all their
/// corners in the same places, to 1e-6 of the element's size: the rounding of coordinates is at most 2^-22 = 2.4e-7 of
/// it (see `largest_to_smallest` in mesh/resolution.hpp).
std::vector<std::string> coincident_elements(const Mesh& mesh, const std::vector<int>& piece);

}  // namespace brunt::mesh
