// SPDX-License-Identifier: Apache-2.0
// First passage of a moving point through a moving face, as the first zero of their trilinear distance.
#include "geometry/first_contact.hpp"

#include <Eigen/Geometry>

#include "face_distance.hpp"

namespace brunt::geometry {
namespace {

Trilinear distance_from(const MovingPoint& p, const MovingFace& face) {
  const BilinearFace start = bilinear(face.start), end = bilinear(face.end);
  const Vec3 offset = start.one - p.start;
  return {.one = offset,
          .u = start.u,
          .v = start.v,
          .tau = (end.one - p.end) - offset,
          .uv = start.uv,
          .u_tau = end.u - start.u,
          .v_tau = end.v - start.v,
          .uv_tau = end.uv - start.uv};
}

}  // namespace

std::optional<FirstContact> first_contact(const MovingPoint& point, const MovingFace& face) {
  if (!may_meet(point, sweep_of(face))) return std::nullopt;
  const Trilinear distance = distance_from(point, face);
  const auto zero = first_zero(distance, face_domain(face.start.size()), Crossing::positive);
  if (!zero) return std::nullopt;

  const FacePlace place = place_on_face(face.start.size(), *zero);
  FirstContact result{.tau = std::clamp(zero->tau, 0.0, 1.0),
                      .xi = place.xi,
                      .eta = place.eta,
                      .weights = face_weights(face.start.size(), place.xi, place.eta),
                      .region = place.region};
  result.point = (1 - result.tau) * point.start + result.tau * point.end;
  result.normal = derivative_u(distance, *zero).cross(derivative_v(distance, *zero)).normalized();
  return result;
}

}  // namespace brunt::geometry
