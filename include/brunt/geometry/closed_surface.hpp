// SPDX-License-Identifier: Apache-2.0
// Is a surface of triangles the boundary of a solid? What is wrong with it, how often and where first.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "brunt/core/triangle_surface.hpp"

namespace brunt::geometry {

/// Edges with one fault: how many, and the first side of the first triangle that lies on such an edge.
struct EdgeFaults {
  std::int64_t count = 0;
  LocalIndex triangle = no_index;                           ///< of the first one
  std::int16_t corner = 0;                                  ///< of this triangle, at which its side begins
  std::array<LocalIndex, 2> points = {no_index, no_index};  ///< from this corner to the next
};

struct ItemFaults {
  std::int64_t count = 0;
  LocalIndex first = no_index;
};

/// Triangles that edges connect.
struct Shell {
  LocalIndex first_triangle = no_index;
  std::int64_t triangles = 0;
  double volume = 0;  ///< [length^3] < 0: of a cavity; without meaning for an open shell
};

struct SurfaceFaults {
  EdgeFaults open;          ///< edges of one triangle
  EdgeFaults non_manifold;  ///< edges of more than two triangles
  EdgeFaults reversed;      ///< edges along which two triangles run in the same direction: one of them is reversed
  ItemFaults no_area;       ///< triangles without area
  ItemFaults inside_out;    ///< shells that enclose a negative volume and are no cavities of others
  ItemFaults doubled;       ///< shells that enclose a positive volume inside another: cavities the wrong way round
  std::int64_t unused_points = 0;  ///< points of no triangle: harmless
  std::vector<Shell> shells;       ///< in the order of their first triangles
  double volume = 0;               ///< [length^3] of all shells

  /// The boundary of a solid, apart from crossings, which are not looked for.
  [[nodiscard]] bool sound() const;
};

/// A triangle has no area when its height is below this ratio of its longest side: about 1e4 roundings of a double.
constexpr double least_height_ratio = 1e-12;

/// Checks a surface whose points are merged. Indices of triangles must be sound and coordinates finite.
///
/// Outside a solid the winding number of its boundary is 0, inside it is 1. So the others of its shells must have the
/// winding number 0 around a point of a shell of positive volume, and 1 around one of negative volume, a cavity. The
/// number is the sum of solid angles (Van Oosterom and Strackee 1983) over 4 pi; where shells touch in the point it
/// lies between, and another triangle's centre is taken. This is judged only where the edges are sound.
///
/// Time: sorting of the edges; for the shells, a comparison of boxes for each pair, and the triangles of those shells
/// whose box holds the point.
[[nodiscard]] SurfaceFaults check_closed(const TriangleSurface& surface);

/// One line a fault, "NAME: 12 open edges, the first from (0, 0, 1) to (1, 0, 1); expected a closed surface"; empty for
/// a sound surface. Triangles are counted from 1.
[[nodiscard]] std::vector<std::string> describe(const SurfaceFaults& faults, const TriangleSurface& surface,
                                                const std::string& name);

}  // namespace brunt::geometry
