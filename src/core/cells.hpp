// SPDX-License-Identifier: Apache-2.0
// Numbering of the corners, edges and faces of hexahedra and tetrahedra; all other code refers to these tables.
//
//        7--------6
//       /|       /|      hexahedron: corners 0-3 on the face z-, 4-7 above them; faces as below,
//      4--------5 |      counter-clockwise seen from outside (the Exodus II order, 0-based)
//      | 3------|-2
//      |/       |/       tetrahedron: 0,1,2 counter-clockwise seen from 3
//      0--------1
#pragma once
#include <array>

namespace brunt::cells {

/// Coordinates of the corners in the parent cube [-1, 1]^3.
constexpr std::array<std::array<int, 3>, 8> hex_corners{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

constexpr std::array<std::array<int, 2>, 12> hex_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<std::array<int, 2>, 6> tet_edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// The corners at the other ends of the three edges of each corner, in right-handed order: the triple product of the
/// edges is positive.
constexpr std::array<std::array<int, 3>, 8> hex_neighbours{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

/// Six tetrahedra of positive volume around the diagonal from corner 0 to corner 6. They fill the hexahedron where its
/// faces are plane.
constexpr std::array<std::array<int, 4>, 6> hex_tetrahedra{
    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};

constexpr std::array<std::array<int, 4>, 6> hex_faces{
    {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
/// The entry -1 means that a triangle has no fourth corner.
constexpr std::array<std::array<int, 4>, 4> tet_faces{{{0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}, {0, 2, 1, -1}}};

}  // namespace brunt::cells
