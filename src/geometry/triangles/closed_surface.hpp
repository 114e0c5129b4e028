// SPDX-License-Identifier: Apache-2.0
// Checks that a triangulated surface is the boundary of a solid: kinds of faults, their number and the first place of
// each.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/triangle_surface.hpp"

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

/// Triangles connected by edges.
struct Shell {
  LocalIndex first_triangle = no_index;
  std::int64_t triangles = 0;
  double volume = 0;  ///< [length^3] < 0: of a cavity; without meaning for an open shell
};

struct SurfaceFaults {
  EdgeFaults open;          ///< edges of one triangle
  EdgeFaults non_manifold;  ///< edges of more than two triangles
  EdgeFaults reversed;    ///< edges that two triangles traverse in the same direction: one of the triangles is reversed
  ItemFaults no_area;     ///< triangles without area
  ItemFaults inside_out;  ///< shells with negative volume that are not cavities of others
  ItemFaults doubled;     ///< shells with positive volume inside another shell: reversed cavities
  std::int64_t unused_points = 0;  ///< points of no triangle: harmless
  std::vector<Shell> shells;       ///< in the order of their first triangles
  double volume = 0;               ///< [length^3] of all shells

  /// The surface bounds a solid. Self-intersections are not checked.
  [[nodiscard]] bool sound() const;
};

/// A triangle has no area when its height is below this ratio of its longest side: about 1e4 roundings of a double.
constexpr double least_height_ratio = 1e-12;
[[nodiscard]] bool has_area(const TriangleSurface& surface, const std::array<LocalIndex, 3>& triangle);

/// Checks a surface whose points are merged. Indices of triangles must be sound and coordinates finite.
///
/// The winding number of a solid's boundary is 0 outside and 1 inside. Hence, at a point of a shell of positive volume,
/// the winding number of all other shells must be 0, and at a point of a shell of negative volume (a cavity) it must be
/// 1. It is the sum of solid angles (Van Oosterom and Strackee 1983) divided by 4 pi. If shells touch at the point, the
/// number lies in between, and the centre of another triangle is used. The test requires valid edges.
///
/// Time: sorting of the edges; for the shells, a comparison of boxes for each pair, and the triangles of those shells
/// whose box holds the point.
[[nodiscard]] SurfaceFaults check_closed(const TriangleSurface& surface);

/// One line a fault, "NAME: 12 open edges, the first from (0, 0, 1) to (1, 0, 1); expected a closed surface"; empty for
/// a sound surface. Triangles are counted from 1.
[[nodiscard]] std::vector<std::string> describe(const SurfaceFaults& faults, const TriangleSurface& surface,
                                                const std::string& name);

}  // namespace brunt::geometry
