// SPDX-License-Identifier: Apache-2.0
// Reads meshes from Abaqus input files. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::io {

/// Nodes, solid elements of first order (C3D4, C3D5, C3D6, C3D8 and variants), sets and surfaces, in one piece or as
/// parts and their instances; materials, steps and loads are passed over, as are lines and surfaces that mesh
/// generators write beside solids. Each *SOLID SECTION's element set becomes a block, in the order of the file; where
/// a part has none, each ELSET of its *ELEMENT cards. Hexahedra, wedges and pyramids go to one block of hexahedra (with
/// repeated nodes), tetrahedra of the same set to another, called NAME_tet4 where both occur. Node sets and surfaces
/// become node sets and side sets (of a surface's nodes too) of their names. What belongs to an instance is called
/// INSTANCE.NAME, as in Abaqus; nodes and elements keep their numbers where there is one instance, and are numbered
/// anew in turn where there are several.
/// Included files are read where they are named (*INCLUDE, INPUT=). Other elements are blocks that `ignore` may leave
/// out, by the name of their section's set, their card's ELSET, or their type.
/// Throws InputError, lines beginning with path and line number, for what would change the mesh and is not read
/// (generated nodes, other elements that are not ignored), numbers and names that are not there, an element in two
/// sections or in none beside others that are in one, and all that mesh::check finds.
mesh::Mesh read_abaqus(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
