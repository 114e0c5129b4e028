// SPDX-License-Identifier: Apache-2.0
// A face as a bilinear function of (u, v) in [0, 1]^2, and the inverse map to its own parameters and regions.
#pragma once
#include "geometry/closest_point.hpp"
#include "geometry/first_contact.hpp"
#include "geometry/trilinear.hpp"

namespace brunt::geometry {

/// one + u d_u + v d_v + u v d_uv
struct BilinearFace {
  Vec3 one, u, v, uv;
};

/// Quadrilaterals: u = (1 + xi)/2, v = (1 + eta)/2; triangles: u = xi, v = eta.
inline BilinearFace bilinear(Corners c) {
  if (c.size() == 3) return {c[0], c[1] - c[0], c[2] - c[0], Vec3::Zero()};
  return {c[0], c[1] - c[0], c[3] - c[0], (c[2] - c[3]) - (c[1] - c[0])};
}

/// The face enlarged by face_tolerance, the step by step_tolerance.
inline TrilinearDomain face_domain(std::size_t corner_count) {
  constexpr double t = face_tolerance;
  TrilinearDomain domain{.low = {-t, -t, -step_tolerance}, .high = {1 + t, 1 + t, 1 + step_tolerance}};
  if (corner_count == 3) domain.sum_high = 1 + t;
  return domain;
}

struct FacePlace {
  double xi = 0, eta = 0;
  Region region = Region::face;
};

/// Parameters on the face itself; within face_tolerance of an edge or a vertex the region is that edge or vertex.
FacePlace place_on_face(std::size_t corner_count, const TrilinearPlace& at);

}  // namespace brunt::geometry
