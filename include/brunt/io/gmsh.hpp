// SPDX-License-Identifier: Apache-2.0
// Reads Gmsh meshes, MSH 2.2 and 4.1 in ASCII. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::io {

/// Physical volumes become blocks (name and number as in the file); volume elements in none become a block
/// volume_ENTITY. Hexahedra, prisms and pyramids of a volume go to one block of hexahedra (with repeated nodes), its
/// tetrahedra to another, called NAME_tet4 where both occur. A physical surface becomes a side set (faces found by
/// their nodes; between two elements the one that the surface's normal points out of) and a node set, under its name or
/// number. Lines and points are passed over. `ignore` leaves out physical groups by name or number; of several
/// dimensions the highest is meant.
/// Throws InputError, lines beginning with path and line number, for binary files, other versions, second-order
/// elements that are not ignored, a volume in two physical groups, a physical surface that is no element's face and not
/// ignored, and all that mesh::check finds.
mesh::Mesh read_gmsh(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
