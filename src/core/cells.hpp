// SPDX-License-Identifier: Apache-2.0
// The shapes of elements: corners, edges and faces of hexahedra, tetrahedra, and of the quadrilaterals and triangles of
// shells. All other code refers to these tables.
//
//        7--------6
//       /|       /|      hexahedron: corners 0-3 on the face z-, 4-7 above them; faces as below,
//      4--------5 |      counter-clockwise seen from outside (the Exodus II order, 0-based)
//      | 3------|-2
//      |/       |/       tetrahedron: 0,1,2 counter-clockwise seen from 3
//      0--------1
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/types.hpp"

namespace brunt::cells {

using Edge = std::array<int, 2>;
using Face = std::array<int, 4>;  ///< counter-clockwise seen from outside; -1 where a triangle has no fourth corner
using Tetrahedron = std::array<int, 4>;

// Hexahedron.

/// Coordinates of the corners in the parent cube [-1, 1]^3.
inline constexpr std::array<std::array<int, 3>, 8> hex_corners{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
inline constexpr std::array<Edge, 12> hex_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
inline constexpr std::array<Face, 6> hex_faces{
    {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
/// The corners at the other ends of the three edges of each corner, in right-handed order: the triple product of the
/// edges is positive.
inline constexpr std::array<std::array<int, 3>, 8> hex_neighbours{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
/// Around the diagonal from corner 0 to corner 6.
inline constexpr std::array<Tetrahedron, 6> hex_tetrahedra{
    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};

// Tetrahedron.

inline constexpr std::array<Edge, 6> tet_edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
inline constexpr std::array<Face, 4> tet_faces{{{0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}, {0, 2, 1, -1}}};
inline constexpr std::array<Tetrahedron, 1> tet_tetrahedra{{{0, 1, 2, 3}}};

// Quadrilateral and triangle: counter-clockwise seen from the side to which the normal of the shell points (its top).
// Their one face is the shell itself, seen from there.

inline constexpr std::array<Edge, 4> quad_edges{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
inline constexpr std::array<Face, 1> quad_faces{{{0, 1, 2, 3}}};
inline constexpr std::array<Edge, 3> tri_edges{{{0, 1}, {1, 2}, {2, 0}}};
inline constexpr std::array<Face, 1> tri_faces{{{0, 1, 2, -1}}};

// All shapes.

/// Wedges and pyramids are stored as hex8 with repeated nodes.
enum class Shape { hex8, tet4, quad4, tri3 };

struct Cell {
  std::string_view name;
  int dimension;
  int corners;
  std::span<const Face> faces;
  std::span<const Edge> edges;
  std::span<const Tetrahedron> tetrahedra;  ///< of positive volume; they fill an element whose faces are plane
};

/// In the order of Shape.
inline constexpr std::array<Cell, 4> table{{{"hex8", 3, 8, hex_faces, hex_edges, hex_tetrahedra},
                                            {"tet4", 3, 4, tet_faces, tet_edges, tet_tetrahedra},
                                            {"quad4", 2, 4, quad_faces, quad_edges, {}},
                                            {"tri3", 2, 3, tri_faces, tri_edges, {}}}};

constexpr const Cell& of(Shape shape) {
  return nth(table, shape);
}

constexpr bool is_surface(Shape shape) {
  return of(shape).dimension == 2;
}

/// The shape that stores a solid element with this number of different corners: eight, or six and five of wedges and
/// pyramids; four.
constexpr Shape shape_with(int corners) {
  return corners == of(Shape::tet4).corners ? Shape::tet4 : Shape::hex8;
}

/// Sizes of arrays that hold the corners of an element, or of a face, of any shape.
inline constexpr int most_corners = 8, most_face_corners = 4;

/// The number of corners of a face that is stored as four nodes: the last one is no_index for a triangle.
template <class Index>
constexpr std::size_t corner_count(const std::array<Index, most_face_corners>& nodes) {
  return nodes[3] == no_index ? 3 : 4;
}

/// Keys number the corners, or the faces, of all elements in the order of the elements. Their stride is the largest
/// number of either. Checkpoints contain keys, so it is part of their format.
inline constexpr int key_stride = 8;
static_assert([] {
  for (const Cell& cell : table)
    if (cell.corners > most_corners || cell.corners > key_stride || cell.faces.size() > key_stride) return false;
  return true;
}());

/// local: number of the corner or face in its element.
constexpr GlobalIndex key_of(GlobalIndex element, int local) {
  return element * key_stride + local;
}
constexpr GlobalIndex element_of_key(GlobalIndex key) {
  return key / key_stride;
}
/// Keys of the corners of all faces.
constexpr GlobalIndex key_of_face_corner(GlobalIndex face_key, int corner) {
  return face_key * most_face_corners + corner;
}

}  // namespace brunt::cells
