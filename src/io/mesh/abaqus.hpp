// SPDX-License-Identifier: Apache-2.0
// Reads meshes from Abaqus input files. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::io {

/// Reads nodes, solid elements of first order (C3D4, C3D5, C3D6, C3D8 and variants), shells of first order (S4, S4R,
/// S3, S3R, STRI3 and variants; a surface has their tops, SPOS, or bottoms, SNEG), sets and surfaces, either directly
/// or as parts and their instances, whose mesh is in the part or in the instance. Materials, steps and loads are
/// ignored, as are lines and surfaces that mesh generators write beside solids. The element set of each *SOLID SECTION
/// or *SHELL SECTION (whose data are not read) becomes a block, in the order of the file; in a part without sections,
/// each ELSET of its *ELEMENT cards does. Hexahedra, wedges and pyramids go to one block of hexahedra (with repeated
/// nodes), tetrahedra of the same set to another one, named NAME_tet4 if both occur. Node sets and surfaces become node
/// sets and side sets of the same names (surfaces give both). Objects of an instance are named INSTANCE.NAME, as in
/// Abaqus. Nodes and elements keep their numbers if there is one instance, and are renumbered in order if there are
/// several. Included files are read at their place (*INCLUDE, INPUT=). Other elements are blocks that `ignore` may
/// exclude, by the name of their section's set, the ELSET of their card, or their type. Mesh::notes say what is not
/// read: unknown keywords, numbers of GENERATE that do not exist, points of the assembly. Throws InputError, with path
/// and line number, for keywords and parameters that would change the mesh and are not supported (the table in
/// src/io/README.md), for other elements that are not ignored, for unknown numbers and names, for an element in two
/// sections, or in none if others have one, and for all faults found by mesh::check.
mesh::Mesh read_abaqus(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
