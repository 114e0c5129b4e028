// SPDX-License-Identifier: Apache-2.0
// Intersection of a segment with a face, as the first zero of face(u, v) - segment(tau).
#include "geometry/segment_face.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "face_distance.hpp"
#include "geometry/first_contact.hpp"

namespace brunt::geometry {

std::optional<SegmentFaceCrossing> segment_crosses_face(const Segment& segment, Corners corners) {
  if (!may_meet({segment.start, segment.end}, sweep_of({corners, corners}))) return std::nullopt;
  const BilinearFace face = bilinear(corners);
  const Trilinear distance{
      .one = face.one - segment.start, .u = face.u, .v = face.v, .tau = segment.start - segment.end, .uv = face.uv};
  const auto zero = first_zero(distance, face_domain(corners.size()), Crossing::either);
  if (!zero) return std::nullopt;

  const FacePlace place = place_on_face(corners.size(), *zero);
  SegmentFaceCrossing result{.along = std::clamp(zero->tau, 0.0, 1.0),
                             .xi = place.xi,
                             .eta = place.eta,
                             .weights = face_weights(corners.size(), place.xi, place.eta),
                             .region = place.region};
  result.point = (1 - result.along) * segment.start + result.along * segment.end;
  result.normal = derivative_u(distance, *zero).cross(derivative_v(distance, *zero)).normalized();
  result.inward = result.normal.dot(segment.end - segment.start) < 0;
  return result;
}

}  // namespace brunt::geometry
