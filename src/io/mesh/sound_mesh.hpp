// SPDX-License-Identifier: Apache-2.0
// The last step of every mesh reader.
#pragma once
#include <array>
#include <string>

#include "mesh/mesh.hpp"

namespace brunt::io {

/// Throws the faults found by mesh::check as one InputError, each line beginning with the path.
mesh::Mesh sound_mesh(const std::string& path, mesh::Mesh&& mesh);

/// A wedge's or pyramid's nodes as those of a hexahedron that is collapsed so that side numbers of hexahedron and
/// pyramid agree (Exodus II manual, SAND92-2137, element side numbering); `count` is 8, 6 or 5.
std::array<int, 8> hex_corners(int count);

}  // namespace brunt::io
