// SPDX-License-Identifier: Apache-2.0
// Reads Exodus II meshes. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::io {

/// Reads blocks of HEX8, TET4, and WEDGE6 or PYRAMID5 as hexahedra with repeated nodes; ids, names, number maps, node
/// sets and side sets (by name, or by number if unnamed). Time steps and distribution factors are ignored. `ignore`
/// excludes blocks, including those of other elements. The library accepts truncated files, so the size of the file is
/// first compared with its header. The mesh is checked by mesh::check. Throws InputError; each line begins with the
/// path.
mesh::Mesh read_exodus(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
