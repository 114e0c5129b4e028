// SPDX-License-Identifier: Apache-2.0
// The part of a segment inside a tetrahedron or hexahedron; a point is a segment without length.
#pragma once
#include <span>

#include "geometry/segments.hpp"

namespace brunt::geometry {

/// Places along a segment, from 0 at its start to 1 at its end. Empty if the first is the larger.
struct Stretch {
  double first = 1, last = 0;

  [[nodiscard]] bool is_empty() const { return first > last; }
  [[nodiscard]] double length() const { return is_empty() ? 0.0 : last - first; }  ///< share of the segment's
};

/// The part of the segment in a closed cell of 4 or 8 corners, in the order of core/cells.hpp. A hexahedron is the six
/// tetrahedra of cells::hex_tetrahedra: the result reaches from where the segment enters the first of them to where it
/// leaves the last. Flat and inverted tetrahedra contain nothing. slack: share of the volume of a tetrahedron by which
/// a point may lie outside of a face, for rounding.
Stretch part_in_cell(const Segment& segment, std::span<const Vec3> corners, double slack = 0);

}  // namespace brunt::geometry
