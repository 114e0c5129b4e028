// SPDX-License-Identifier: Apache-2.0
// Exterior faces and connected components of elements. Corners and faces are numbered as in core/cells.hpp.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

/// Distinct nodes of a face in order, counter-clockwise seen from outside. The last one is no_index for a triangle
/// (also for a quadrilateral of a degenerate hexahedron with one repeated node). All are no_index if fewer than three
/// nodes are distinct. Of a shell: 0 the top, 1 the bottom, whose order is reversed.
std::array<LocalIndex, 4> face_nodes(Shape shape, const LocalIndex* element, int face);

/// Sides that no other element shares, ordered by (block, element, face). A shell is exterior once, as its top, unless
/// it lies between two solid elements; a solid element's face that a shell covers is not exterior.
std::vector<Side> exterior_sides(const Mesh& mesh);

/// Sides that another element shares and whose nodes are all `wanted` (a flag a node), ordered likewise.
std::vector<Side> interior_sides(const Mesh& mesh, std::span<const char> wanted);

/// Connected component of each element (elements that share a node are connected), block by block; components are
/// numbered by their first element.
std::vector<std::int32_t> bodies(const Mesh& mesh);

}  // namespace brunt::mesh
