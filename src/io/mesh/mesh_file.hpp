// SPDX-License-Identifier: Apache-2.0
// Reads a mesh file of any supported kind. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::io {

/// Determines the kind from the first bytes (Exodus: netCDF or HDF5 signature; Gmsh: $MeshFormat or $Comments; Abaqus:
/// a star, but not *KEYWORD, perhaps behind a byte-order mark and blank lines), independent of the name. Throws
/// InputError if the file cannot be read, is of unknown kind, or is invalid. `ignore`: names or numbers of blocks to
/// exclude, including blocks of unsupported elements; Mesh::left_out and Mesh::notes list what was excluded.
mesh::Mesh read_mesh(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
