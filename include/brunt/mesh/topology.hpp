// SPDX-License-Identifier: Apache-2.0
// Numbering of element faces, exterior faces, and which elements hang together.
//
//        7--------6
//       /|       /|      hex8: nodes 0-3 on the face z-, 4-7 above them; faces as below,
//      4--------5 |      counter-clockwise seen from outside (the Exodus II order, 0-based)
//      | 3------|-2
//      |/       |/       tet4: 0,1,2 counter-clockwise seen from 3
//      0--------1
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::mesh {

constexpr std::array<std::array<int, 4>, 6> hex_faces{
    {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
constexpr std::array<std::array<int, 4>, 4> tet_faces{{{0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}, {0, 2, 1, -1}}};

/// Distinct nodes of a face in order, from outside counter-clockwise; the last is no_index for a triangle (also for a
/// quadrilateral of a degenerate hex with one repeated node). All no_index where fewer than three nodes are distinct.
std::array<LocalIndex, 4> face_nodes(Shape shape, const LocalIndex* element, int face);

/// Sides that no other element shares, ordered by (block, element, face).
std::vector<Side> exterior_sides(const Mesh& mesh);

/// Connected component of each element (elements that share a node hang together), block by block; components are
/// numbered by their first element.
std::vector<std::int32_t> bodies(const Mesh& mesh);

}  // namespace brunt::mesh
