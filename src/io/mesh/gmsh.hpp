// SPDX-License-Identifier: Apache-2.0
// Reads Gmsh meshes, MSH 2.2 and 4.1 in ASCII. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::io {

/// Physical volumes become blocks (name and number as in the file); volume elements outside physical volumes become a
/// block volume_ENTITY. Hexahedra, prisms and pyramids of a volume go to one block of hexahedra (with repeated nodes),
/// its tetrahedra to another one, named NAME_tet4 if both occur. A physical surface becomes a side set (faces are found
/// by their nodes; between two elements, the face whose outward normal agrees with the surface) and a node set, under
/// its name or number. A physical surface, none of whose elements is the face
/// of a volume element, is a block of shells of its name and number (its triangles another one, named NAME_tri3, if it
/// has quadrilaterals too), and its tops are the side set; so are all surfaces, surface_ENTITY, of a file with neither
/// volumes nor groups of surfaces. Physical curves are node sets in files with shells. Other lines and points are
/// ignored. `ignore` excludes physical groups by name or number; if groups of
/// several dimensions match, that of the highest dimension is meant. Throws InputError, with path and line number, for
/// binary files, other versions, second-order elements that are not ignored, a volume in two physical groups, a
/// physical surface that is partly on faces of elements, unless it is ignored, and all faults found by mesh::check.
mesh::Mesh read_gmsh(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
