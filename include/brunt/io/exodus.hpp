// SPDX-License-Identifier: Apache-2.0
// Reads Exodus II meshes. Not collective: for the root rank.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::io {

/// Blocks of HEX8, TET4, and WEDGE6 or PYRAMID5 as hexahedra with repeated nodes; ids, names, number maps, node sets
/// and side sets (by name, or by number where unnamed). Time steps and distribution factors are passed over;
/// `ignore` leaves out blocks, of other elements too. The
/// library takes a file that was cut off for a good one, so the file's size is held against its header first, and the
/// mesh passes mesh::check. Throws InputError, lines beginning with the path.
mesh::Mesh read_exodus(const std::string& path, const std::vector<std::string>& ignore = {});

}  // namespace brunt::io
