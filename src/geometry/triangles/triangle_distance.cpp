// SPDX-License-Identifier: Apache-2.0
// Nearest points of two triangles: corners to triangles and edges to edges, three at a time in the lanes of a quad.
#include <algorithm>
#include <cmath>

#include "exact_sign.hpp"
#include "geometry/triangles/triangle_pair.hpp"
#include "triangle_point.hpp"

namespace brunt::geometry {
namespace {

using QuadVec = VecOf<Quad>;

BRUNT_INLINE QuadVec everywhere(const Vec3& p) {
  return {Quad() + p[0], Quad() + p[1], Quad() + p[2]};
}

BRUNT_INLINE Quad size_of(Quad a) {
  return a < 0.0 ? -a : a;
}

/// One of the two triangles: its corners and edges in lanes, and derived values.
struct Side {
  SidePlane plane;
  QuadVec corners, edges;  ///< corner and edge i in lane i; the last lane repeats corner 0
  Quad inverse2;           ///< one over the squared lengths of the edges and, in the last lane, of the normal

  BRUNT_INLINE explicit Side(const Triangle& t) : plane(t) {
    const auto component = [&](int c) { return Quad{t[0][c], t[1][c], t[2][c], t[0][c]}; };
    const auto next = [](Quad q) { return __builtin_shufflevector(q, q, 1, 2, 0, 1); };
    corners = {component(0), component(1), component(2)};
    edges = QuadVec{next(corners.x), next(corners.y), next(corners.z)} - corners;
    Quad length2 = dot(edges, edges);
    length2[3] = dot(vec_of(plane.normal), vec_of(plane.normal));
    inverse2 = (Quad() + 1.0) / length2;
  }

  [[nodiscard]] BRUNT_INLINE TriangleOf<Quad> everywhere_of(const Triangle& t) const {
    return {everywhere(t[0]),     everywhere(t[1]),     everywhere(t[2]),     everywhere(plane.normal),
            Quad() + inverse2[0], Quad() + inverse2[1], Quad() + inverse2[2], Quad() + inverse2[3]};
  }
};

/// Squared distance along the common perpendicular of two edges, infinite if a foot lies outside its edge: the ends of
/// edges are treated as corners. For nearly parallel edges s is uncertain, but t is consistent with it and the distance
/// hardly depends on s.
BRUNT_INLINE Quad perpendicular2(const QuadVec& a, const QuadVec& u, const Side& b) {
  const QuadVec between = b.corners - a, normal = cross(u, b.edges);
  const Quad zero = Quad(), one = zero + 1.0;
  const Quad s = dot(cross(between, b.edges), normal) / dot(normal, normal);
  const QuadVec from_b = s * u - between;
  const Quad t = dot(from_b, b.edges) * b.inverse2;
  const QuadVec apart = from_b - t * b.edges;
  const QuadMask meets = (s > zero) & (s < one) & (t > zero) & (t < one);
  return meets ? dot(apart, apart) : zero + std::numeric_limits<double>::infinity();
}

/// The nearest candidate: corner `i` of a (kind 0) or of b (kind 1) to the other triangle, or the edges j of a and i of
/// b (kind 2 + j).
struct Candidate {
  double distance2 = std::numeric_limits<double>::infinity();
  std::size_t kind = 0, i = 0;
};

/// The nearest of each lane so far.
struct LaneCandidates {
  Quad distance2 = Quad() + std::numeric_limits<double>::infinity();
  QuadMask kind = {};
  void consider(Quad other, std::int64_t other_kind) {
    const QuadMask nearer = other < distance2;
    distance2 = nearer ? other : distance2;
    kind = nearer ? QuadMask() + other_kind : kind;
  }
};

Candidate nearest_candidate(const Triangle& a, const Triangle& b, const Side& side_a, const Side& side_b) {
  LaneCandidates lanes;
  lanes.consider(distance2_to_triangle(side_a.corners, side_b.everywhere_of(b)), 0);
  lanes.consider(distance2_to_triangle(side_b.corners, side_a.everywhere_of(a)), 1);
  for (std::size_t j = 0; j < 3; ++j)
    lanes.consider(perpendicular2(everywhere(a[j]), everywhere(a[(j + 1) % 3] - a[j]), side_b),
                   2 + static_cast<std::int64_t>(j));
  std::size_t best = lanes.distance2[1] < lanes.distance2[0] ? 1 : 0;
  if (lanes.distance2[2] < lanes.distance2[static_cast<int>(best)]) best = 2;
  const auto lane = static_cast<int>(best);
  return {lanes.distance2[lane], static_cast<std::size_t>(lanes.kind[lane]), best};
}

/// The smallest positive number if it is 0 up to rounding: triangles that do not intersect have a distance.
double distance_of(const Candidate& nearest) {
  return std::max(std::sqrt(nearest.distance2), std::numeric_limits<double>::min());
}

NearestPoints points_of(const Triangle& a, const Triangle& b, const Candidate& nearest) {
  NearestPoints result;
  if (nearest.kind == 0) {
    result.on_a = a[nearest.i];
    result.on_b = nearest_on(b, result.on_a).point;
  } else if (nearest.kind == 1) {
    result.on_b = b[nearest.i];
    result.on_a = nearest_on(a, result.on_b).point;
  } else {
    const std::size_t i = nearest.i, j = nearest.kind - 2;
    const Vec3 u = a[(j + 1) % 3] - a[j], v = b[(i + 1) % 3] - b[i], between = b[i] - a[j];
    const Vec3 normal = accurate_cross(u, v);
    const double s = clamp_to_unit(between.cross(v).dot(normal) / normal.squaredNorm());
    const double t = clamp_to_unit((s * u - between).dot(v) / v.squaredNorm());
    result.on_a = a[j] + s * u;
    result.on_b = b[i] + t * v;
  }
  result.distance = distance_of(nearest);
  return result;
}

/// A common point of intersecting triangles: where an edge pierces the other triangle, or a candidate if they touch.
NearestPoints common_point(const Triangle& a, const Triangle& b, const Candidate& nearest) {
  const NearestPoints touching = points_of(a, b, nearest);
  Vec3 common = 0.5 * (touching.on_a + touching.on_b);
  double least = touching.distance;
  const auto pierce = [&](const Triangle& edges, const Triangle& face) {
    const Vec3 normal = accurate_cross(face[1] - face[0], face[2] - face[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &from = edges[i], &to = edges[(i + 1) % 3];
      const double h_from = (from - face[0]).dot(normal), h_to = (to - face[0]).dot(normal);
      if (!(h_from * h_to < 0)) continue;
      const Vec3 through = from + h_from / (h_from - h_to) * (to - from);
      const double distance = (through - nearest_on(face, through).point).norm();
      if (!(distance < least)) continue;
      least = distance;
      common = through;
    }
  };
  pierce(a, b);
  pierce(b, a);
  return {0, common, common};
}

/// Whether the triangle is certainly on one side of the plane, at a distance above the bound.
struct PlaneGap {
  bool apart = false, far = false;
  BRUNT_INLINE PlaneGap(const Side& face, const Side& other, double nearer_than) {
    const QuadVec d = other.corners - everywhere(face.plane.origin);
    const Vec3 &n = face.plane.normal, &bound = face.plane.bound;
    const Quad height = d.x * n[0] + d.y * n[1] + d.z * n[2];
    const Quad rounding =
        (size_of(d.x) * bound[0] + size_of(d.y) * bound[1] + size_of(d.z) * bound[2]) * determinant_rounding;
    const Quad above = height - rounding, below = -height - rounding;
    const double least = std::max(std::min({above[0], above[1], above[2]}), std::min({below[0], below[1], below[2]}));
    apart = least > 0;
    const double limit = nearer_than * (n.norm() + determinant_rounding * bound.norm()) * (1 + determinant_rounding);
    far = apart && least > limit;
  }
};

}  // namespace

NearestPoints nearest_points(const Triangle& a, const Triangle& b, double nearer_than) {
  const Side side_a(a), side_b(b);
  const PlaneGap over_a(side_a, side_b, nearer_than), over_b(side_b, side_a, nearer_than);
  if (over_a.far || over_b.far) return {nearer_than, a[0], b[0]};
  const Candidate nearest = nearest_candidate(a, b, side_a, side_b);
  if (!over_a.apart && !over_b.apart && triangles_cross(a, b)) return common_point(a, b, nearest);
  const double distance = distance_of(nearest);
  return distance < nearer_than ? points_of(a, b, nearest) : NearestPoints{distance, a[0], b[0]};
}

NearestPoints nearest_points(const Triangle& a, const Triangle& b) {
  return nearest_points(a, b, std::numeric_limits<double>::infinity());
}

}  // namespace brunt::geometry
