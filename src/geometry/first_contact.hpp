// SPDX-License-Identifier: Apache-2.0
// First time and place at which a moving point passes through a moving face: the velocity-based check of Heinstein et
// al. 2000, section 4.5. All motion is linear over the step, from tau = 0 to tau = 1.
#pragma once
#include <algorithm>

#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::geometry {

struct MovingPoint {
  Vec3 start, end;  ///< positions at the start and the end of the step
};

/// Three or four corners, counter-clockwise seen from outside, at the start and the end of the step.
struct MovingFace {
  Corners start, end;
};

/// Boxes of a face at the start and the end of the step, computed once for each face and used for all points near it.
struct FaceSweep {
  Box start, end;
};

inline FaceSweep sweep_of(const MovingFace& face) {
  return {bounding_box(face.start), bounding_box(face.end)};
}

/// A zero of tau this far outside [0, 1] still counts (as 0 or 1), so that an event at the boundary of two steps is
/// found in at least one of them despite rounding.
constexpr double step_tolerance = 1e-12;

/// False only if the point cannot meet the face, in a frame that moves with the point: rejects nearly all pairs with a
/// few comparisons. Never false for an intersection within face_tolerance and step_tolerance.
inline bool may_meet(const MovingPoint& point, const FaceSweep& face) {
  const Vec3 low = (face.start.low - point.start).cwiseMin(face.end.low - point.end);
  const Vec3 high = (face.start.high - point.start).cwiseMax(face.end.high - point.end);
  const Vec3 margin = 4 * face_tolerance * (high - low);  // of the enlarged face
  return ((low - margin).array() <= 0).all() && ((high + margin).array() >= 0).all();
}

struct FirstContact {
  double tau = 0;                   ///< in [0, 1], exact to about 1e-15 / sin(angle of incidence)
  double xi = 0, eta = 0;           ///< on the face, as closest_point has them
  std::array<double, 4> weights{};  ///< of the corners, sum 1; the last is 0 for a triangle
  Vec3 point = Vec3::Zero();        ///< where the point is at tau
  Vec3 normal = Vec3::Zero();       ///< outward unit normal of the face there at tau
  Region region =
      Region::face;  ///< edge or vertex within face_tolerance of one: neighbouring faces report the same one
};

/// The earliest tau at which the point crosses the face from outside to inside: the relative velocity has a negative
/// component along the outward normal. Crossings outwards are ignored. The face is enlarged by face_tolerance, so that
/// a point that hits a shared edge or vertex meets at least one of its faces. Sliding in the face, and touching without
/// passing through, are not crossings (see `transversal`). Empty for faces without area and for values that are not
/// finite; never NaN. It is a zero of the trilinear distance, see first_zero.
std::optional<FirstContact> first_contact(const MovingPoint& point, const MovingFace& face);

}  // namespace brunt::geometry
