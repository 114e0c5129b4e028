// SPDX-License-Identifier: Apache-2.0
// The point of a triangle nearest to a point: as a distance in lanes, for searches, and with all related data.
#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "geometry/triangles/slab_tree.hpp"
#include "geometry/vec_of.hpp"

namespace brunt::geometry {

/// Clamps to [0, 1]; NaN (0 / 0 of an edge without length) becomes 0.
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
BRUNT_INLINE void consider_edge(const VecOf<T>& edge, T inverse2, const VecOf<T>& from_corner,
                                NearestEdge<T>& nearest) {
  const T t = clamp_to_unit<T>(dot(from_corner, edge) * inverse2);
  const VecOf<T> away = from_corner - t * edge;
  const T distance2 = dot(away, away);
  const auto nearer = distance2 < nearest.distance2;
  nearest.distance2 = nearer ? distance2 : nearest.distance2;
  nearest.away = {nearer ? away.x : nearest.away.x, nearer ? away.y : nearest.away.y, nearer ? away.z : nearest.away.z};
}

/// A triangle prepared for searches: corners, the normal (b - a) x (c - a), and the reciprocals of the squared lengths
/// of the edges and of the normal (infinite for zero length).
template <class T>
struct TriangleOf {
  VecOf<T> a, b, c, normal;
  T edge0, edge1, edge2, face;
};

template <class T>
BRUNT_INLINE TriangleOf<T> triangle_of(const VecOf<T>& a, const VecOf<T>& b, const VecOf<T>& c) {
  const VecOf<T> ab = b - a, bc = c - b, ac = c - a, normal = cross(ab, ac);
  const T one = T() + 1.0;
  return {a, b, c, normal, one / dot(ab, ab), one / dot(bc, bc), one / dot(ac, ac), one / dot(normal, normal)};
}

/// Squared distance of the point p to the triangle; never NaN for finite input. In a sliver the height over its plane
/// is measured from the nearest edge, so that errors of its normal have little effect.
template <class T>
BRUNT_INLINE T distance2_to_triangle(const VecOf<T>& p, const TriangleOf<T>& t) {
  const VecOf<T> ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c, pa = p - t.a, pb = p - t.b, pc = p - t.c;
  const T infinite = T() + std::numeric_limits<double>::infinity(), zero = T();
  NearestEdge<T> nearest{pa, infinite};
  consider_edge(ab, t.edge0, pa, nearest);
  consider_edge(bc, t.edge1, pb, nearest);
  consider_edge(ca, t.edge2, pc, nearest);
  const auto inside = (dot(cross(ab, pa), t.normal) >= zero) & (dot(cross(bc, pb), t.normal) >= zero) &
                      (dot(cross(ca, pc), t.normal) >= zero);
  const T height = dot(nearest.away, t.normal), over_face = height * height * t.face;
  return (inside & (over_face < nearest.distance2)) ? over_face : nearest.distance2;
}

/// The vector product of two vectors, each component with an error of two units in its last place (Kahan).
inline Vec3 accurate_cross(const Vec3& u, const Vec3& v) {
  const auto difference = [](double a, double b, double c, double d) {  // a b - c d
    const double second = c * d, second_error = std::fma(-c, d, second);
    return std::fma(a, b, -second) + second_error;
  };
  return {difference(u[1], v[2], u[2], v[1]), difference(u[2], v[0], u[0], v[2]), difference(u[0], v[1], u[1], v[0])};
}

struct OnTriangle {
  Vec3 point = Vec3::Zero();
  TriangleFeature feature = TriangleFeature::corner0;
};

OnTriangle nearest_on(const Triangle& triangle, const Vec3& p);

}  // namespace brunt::geometry
