// SPDX-License-Identifier: Apache-2.0
#include "geometry/segment_in_cell.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/cells.hpp"

namespace brunt::geometry {
namespace {

double volume(const std::array<Vec3, 4>& tet) {
  return (tet[1] - tet[0]).cross(tet[2] - tet[0]).dot(tet[3] - tet[0]);
}

double longest_edge(const std::array<Vec3, 4>& tet) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < i; ++k) longest = std::max(longest, (tet[i] - tet[k]).norm());
  return longest;
}

/// The volumes that a point makes with the four faces are linear along the segment.
Stretch part_in_tetrahedron(const Segment& segment, const std::array<Vec3, 4>& tet, double slack) {
  constexpr double flat = 1e-12;  // a tetrahedron of repeated corners, of a wedge or pyramid, has rounding for a volume
  const double whole = volume(tet), longest = longest_edge(tet);
  if (!(whole > flat * longest * longest * longest)) return {};
  Stretch part{0, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto above_face = [&](const Vec3& x) {
      std::array<Vec3, 4> with_point = tet;
      with_point[i] = x;
      return volume(with_point) + slack * whole;
    };
    const double start = above_face(segment.start), end = above_face(segment.end);
    if (!(start >= 0 || end >= 0)) return {};
    if (start < 0) part.first = std::max(part.first, start / (start - end));
    if (end < 0) part.last = std::min(part.last, start / (start - end));
  }
  return part;
}

}  // namespace

Stretch part_in_cell(const Segment& segment, std::span<const Vec3> corners, double slack) {
  if (corners.size() == 4) return part_in_tetrahedron(segment, {corners[0], corners[1], corners[2], corners[3]}, slack);
  Stretch part;
  for (const std::array<int, 4>& tet : cells::hex_tetrahedra) {
    std::array<Vec3, 4> of_tet;
    for (std::size_t i = 0; i < 4; ++i) of_tet[i] = nth(corners, tet[i]);
    const Stretch one = part_in_tetrahedron(segment, of_tet, slack);
    if (!one.is_empty()) part = {std::min(part.first, one.first), std::max(part.last, one.last)};
  }
  return part;
}

}  // namespace brunt::geometry
