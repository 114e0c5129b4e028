// SPDX-License-Identifier: Apache-2.0
// Reads a mesh file of any kind known. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::io {

/// Tells the kind by the first bytes (Exodus: netCDF or HDF5 signature; Gmsh: $MeshFormat or $Comments; Abaqus:
/// a star, but not *KEYWORD), whatever the file's name. Throws InputError if the file cannot be read, is of no known
/// kind, or is faulty. `ignore`: names or numbers of blocks that are left out, those of elements that are not read
/// among them; Mesh::left_out and Mesh::notes say what this took away.
mesh::Mesh read_mesh(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
