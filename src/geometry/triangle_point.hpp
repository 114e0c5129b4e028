// SPDX-License-Identifier: Apache-2.0
// The point of a triangle nearest to a point: as a number in lanes, for searches, and with all that belongs to it.
#pragma once
#include <Eigen/Geometry>

#include "brunt/geometry/slab_tree.hpp"
#include "brunt/geometry/vec_of.hpp"

namespace brunt::geometry {

/// Into [0, 1]; what is not a number (0 / 0 of an edge without length) becomes 0.
template <class T>
BRUNT_INLINE T clamp_to_unit(T t) {
  const T zero = T(), one = zero + 1.0;
  const T positive = t > zero ? t : zero;
  return positive < one ? positive : one;
}

/// The nearest point of an edge so far, as the vector from it.
template <class T>
struct NearestEdge {
  VecOf<T> away;
  T distance2;
};

template <class T>
BRUNT_INLINE void consider_edge(const VecOf<T>& edge, const VecOf<T>& from_corner, NearestEdge<T>& nearest) {
  const T t = clamp_to_unit<T>(dot(from_corner, edge) / dot(edge, edge));
  const VecOf<T> away = from_corner - t * edge;
  const T distance2 = dot(away, away);
  const auto nearer = distance2 < nearest.distance2;
  nearest.distance2 = nearer ? distance2 : nearest.distance2;
  nearest.away = {nearer ? away.x : nearest.away.x, nearer ? away.y : nearest.away.y, nearer ? away.z : nearest.away.z};
}

/// Squared distance of the point p to the triangle a, b, c: of all that is finite a number. In a sliver the height over
/// its plane is measured from the nearest edge, so that the direction of the plane need not be exact.
template <class T>
BRUNT_INLINE T distance2_to_triangle(const VecOf<T>& p, const VecOf<T>& a, const VecOf<T>& b, const VecOf<T>& c) {
  const VecOf<T> ab = b - a, bc = c - b, ca = a - c, pa = p - a, pb = p - b, pc = p - c;
  const T infinite = T() + std::numeric_limits<double>::infinity();
  NearestEdge<T> nearest{pa, infinite};
  consider_edge(ab, pa, nearest);
  consider_edge(bc, pb, nearest);
  consider_edge(ca, pc, nearest);
  const VecOf<T> normal = cross(ca, ab);
  const T zero = T();
  const auto inside = (dot(cross(ab, pa), normal) >= zero) & (dot(cross(bc, pb), normal) >= zero) &
                      (dot(cross(ca, pc), normal) >= zero);
  const T height = dot(nearest.away, normal), over_face = height * height / dot(normal, normal);
  return (inside & (over_face < nearest.distance2)) ? over_face : nearest.distance2;
}

/// The vector product of two vectors, each component with an error of two units in its last place (Kahan).
Vec3 accurate_cross(const Vec3& u, const Vec3& v);

struct OnTriangle {
  Vec3 point = Vec3::Zero();
  TriangleFeature feature = TriangleFeature::corner0;
};

OnTriangle nearest_on(const Triangle& triangle, const Vec3& p);

/// What `distance2_to_triangle` finds for p, to the same bits as in a lane.
inline double distance2_to(const Triangle& t, const Vec3& p) {
  return distance2_to_triangle(vec_of(p), vec_of(t[0]), vec_of(t[1]), vec_of(t[2]));
}

}  // namespace brunt::geometry
