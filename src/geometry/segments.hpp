// SPDX-License-Identifier: Apache-2.0
// Two straight segments: where they cross as seen along a direction, and the first contact of moving ones
// (edge-to-edge contact).
#pragma once
#include <cstdint>
#include <optional>

#include "core/types.hpp"

namespace brunt::geometry {

struct Segment {
  Vec3 start, end;
  [[nodiscard]] Vec3 along() const { return (end - start).normalized(); }  ///< unit
};

/// Position of a point on a segment.
enum class Along : std::int8_t { inside, start, end };

/// Edges with a sine of their angle below this are parallel: they define no normal.
constexpr double parallel_sine = 1e-6;

struct CommonPerpendicular {
  double s = 0, t = 0;
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< the given direction
  double gap = 0;              ///< (on_a - on_b) . normal: the sign tells on which side a lies [length]
  bool past_an_end = false;    ///< of a or b
};

/// Where two segments cross as seen along a unit direction, if the line of sight meets both (enlarged by face_tolerance
/// of their lengths, s and t clamped) or passes their ends at no more than `kink` |gap| times the sine of their angle.
/// The latter is needed where two edges of a chain meet at such an angle: the foot of a perpendicular on the outer side
/// lies on neither edge. Segments that are parallel in this view, segments without length, and values that are not
/// finite do not cross.
std::optional<CommonPerpendicular> crossing_along(const Segment& a, const Segment& b, const Vec3& direction,
                                                  double kink = 0);

/// A segment at the start (tau = 0) and the end (tau = 1) of a step, with linear motion between.
struct MovingSegment {
  Segment start, end;
};

struct EdgeCrossing {
  double tau = 0;  ///< in [0, 1]
  double s = 0, t = 0;
  Along along_a = Along::inside, along_b = Along::inside;  ///< start and end within face_tolerance of them
  Vec3 point = Vec3::Zero();                               ///< where they meet
  Vec3 normal = Vec3::Zero();  ///< unit, along +-(a x b) at tau; the velocity of a relative to b along it is negative
};

/// The earliest tau at which the edges a and b intersect, each enlarged by face_tolerance of its length. The error of
/// tau is about 1e-15 / sin(angle of the edges) / sin(incidence). Edges that only touch, slide in their common plane,
/// or are parallel at that instant do not intersect. Never NaN. It is a zero of the trilinear distance, see first_zero.
std::optional<EdgeCrossing> edge_crossing(const MovingSegment& a, const MovingSegment& b);

}  // namespace brunt::geometry
