// SPDX-License-Identifier: Apache-2.0
// When and where does a moving point first pass through a moving face? The velocity-based check of Heinstein et al.
// 2000, section 4.5: all motion is linear over the step, tau = 0 is its start and tau = 1 its end.
#pragma once
#include <algorithm>

#include "brunt/geometry/box.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::geometry {

struct MovingPoint {
  Vec3 start, end;  ///< positions at the start and the end of the step
};

/// Three or four corners, counter-clockwise seen from outside, at the start and the end of the step.
struct MovingFace {
  Corners start, end;
};

/// Boxes of a face at the start and the end of the step: made once a face and used for all points near it.
struct FaceSweep {
  Box start, end;
};

inline FaceSweep sweep_of(const MovingFace& face) {
  return {bounding_box(face.start), bounding_box(face.end)};
}

/// A zero of tau this far outside [0, 1] still counts (as 0 or 1), so that what happens at the border of two steps is
/// seen by one of them at least, whatever rounding does.
constexpr double step_tolerance = 1e-12;

/// False only if the point cannot meet the face, seen from a frame that moves with the point: rejects nearly all pairs
/// at the cost of a few comparisons. Never false for a meeting within face_tolerance and step_tolerance.
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
  Region region = Region::face;     ///< edge or vertex within face_tolerance of one: neighbours name the same
};

/// The earliest tau at which the point crosses the face from outside to inside, i.e. its velocity relative to the
/// face's has a negative part along the outward normal; crossings outward are passed over. The face is enlarged by
/// face_tolerance, so that a point that hits a shared edge or vertex meets at least one of the faces there. Sliding in
/// the face, and touching without passing, is no crossing (see `transversal`). Nothing for faces without area and for
/// input that is not finite; never NaN. A zero of the trilinear distance, see first_zero.
std::optional<FirstContact> first_contact(const MovingPoint& point, const MovingFace& face);

}  // namespace brunt::geometry
