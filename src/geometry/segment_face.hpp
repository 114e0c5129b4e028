// SPDX-License-Identifier: Apache-2.0
// Intersection of a segment with a face: overlaps of thin parts whose nodes may all lie on the correct sides of all
// faces.
#pragma once
#include <array>
#include <optional>

#include "geometry/closest_point.hpp"
#include "geometry/segments.hpp"

namespace brunt::geometry {

struct SegmentFaceCrossing {
  double along = 0;  ///< in [0, 1] from the segment's start
  double xi = 0, eta = 0;
  std::array<double, 4> weights{};
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< outward unit normal of the face there
  bool inward = false;         ///< the segment runs against the normal
  Region region = Region::face;
};

/// The first point at which the segment passes through a triangle or a bilinear quadrilateral (which it can intersect
/// twice), both enlarged by face_tolerance, and the ends of the segment by step_tolerance. Exact to rounding; a
/// triangle is one linear system. A segment in the plane of the face does not intersect it. Empty for faces without
/// area, segments without length, and values that are not finite.
std::optional<SegmentFaceCrossing> segment_crosses_face(const Segment& segment, Corners corners);

}  // namespace brunt::geometry
