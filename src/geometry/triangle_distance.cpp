// SPDX-License-Identifier: Apache-2.0
// Nearest points of two triangles: corners to triangles and edges to edges, three at a time in the lanes of a quad.
#include <algorithm>
#include <cmath>

#include "brunt/geometry/triangle_pair.hpp"
#include "exact_sign.hpp"
#include "triangle_point.hpp"

namespace brunt::geometry {
namespace {

using QuadVec = VecOf<Quad>;

QuadVec everywhere(const Vec3& p) {
  return {Quad() + p[0], Quad() + p[1], Quad() + p[2]};
}

/// Corner i in lane i; the last lane repeats the first corner.
QuadVec corners(const Triangle& t) {
  const auto component = [&](int c) { return Quad{t[0][c], t[1][c], t[2][c], t[0][c]}; };
  return {component(0), component(1), component(2)};
}

QuadVec next_corners(const QuadVec& c) {
  const auto turned = [](Quad q) { return __builtin_shufflevector(q, q, 1, 2, 0, 1); };
  return {turned(c.x), turned(c.y), turned(c.z)};
}

/// Squared distance of the common perpendicular of two edges, infinite where its foot is on neither: ends of edges are
/// corners. Where s is uncertain, of nearly parallel edges, t belongs to it and the distance hardly depends on s.
Quad perpendicular2(const QuadVec& a, const QuadVec& u, const QuadVec& b, const QuadVec& v) {
  const QuadVec between = b - a, normal = cross(u, v);
  const Quad zero = Quad(), one = zero + 1.0;
  const Quad s = dot(cross(between, v), normal) / dot(normal, normal);
  const QuadVec from_b = s * u - between;
  const Quad t = dot(from_b, v) / dot(v, v);
  const QuadVec apart = from_b - t * v;
  const QuadMask meets = (s > zero) & (s < one) & (t > zero) & (t < one);
  return meets ? dot(apart, apart) : zero + std::numeric_limits<double>::infinity();
}

/// Which candidate is the nearest: corner `i` of a (kind 0) or of b (kind 1) to the other triangle, or the edges i of a
/// and j of b (kind 2).
struct Candidate {
  double distance2 = std::numeric_limits<double>::infinity();
  std::size_t kind = 0, i = 0, j = 0;
};

void consider(Quad distance2, std::size_t kind, std::size_t i, Candidate& nearest) {
  for (std::size_t lane = 0; lane < 3; ++lane)
    if (distance2[lane] < nearest.distance2)
      nearest = kind == 2 ? Candidate{distance2[lane], 2, i, lane} : Candidate{distance2[lane], kind, lane, 0};
}

Candidate nearest_candidate(const Triangle& a, const Triangle& b) {
  const QuadVec corners_a = corners(a), corners_b = corners(b), edges_b = next_corners(corners_b) - corners_b;
  Candidate nearest;
  consider(distance2_to_triangle(corners_a, everywhere(b[0]), everywhere(b[1]), everywhere(b[2])), 0, 0, nearest);
  consider(distance2_to_triangle(corners_b, everywhere(a[0]), everywhere(a[1]), everywhere(a[2])), 1, 0, nearest);
  for (std::size_t i = 0; i < 3; ++i)
    consider(perpendicular2(everywhere(a[i]), everywhere(a[(i + 1) % 3] - a[i]), corners_b, edges_b), 2, i, nearest);
  return nearest;
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
    const Vec3 u = a[(nearest.i + 1) % 3] - a[nearest.i], v = b[(nearest.j + 1) % 3] - b[nearest.j];
    const Vec3 between = b[nearest.j] - a[nearest.i], normal = accurate_cross(u, v);
    const double s = clamp_to_unit(between.cross(v).dot(normal) / normal.squaredNorm());
    const double t = clamp_to_unit((s * u - between).dot(v) / v.squaredNorm());
    result.on_a = a[nearest.i] + s * u;
    result.on_b = b[nearest.j] + t * v;
  }
  // The points are rounded where they are, the candidate's distance is not.
  result.distance = std::max(std::sqrt(nearest.distance2), std::numeric_limits<double>::min());
  return result;
}

/// A common point of triangles that cross: where an edge pierces the other triangle, or a candidate where they touch.
NearestPoints common_point(const Triangle& a, const Triangle& b) {
  const NearestPoints touching = points_of(a, b, nearest_candidate(a, b));
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

/// Whether the plane leaves the triangle on one side, farther away than the bound.
struct PlaneGap {
  bool apart = false, far = false;
  PlaneGap(const Triangle& face, const Triangle& t, double nearer_than) {
    const SidePlane plane(face);
    const std::array<int, 3> side{plane.certain_side(t[0]), plane.certain_side(t[1]), plane.certain_side(t[2])};
    apart = side[0] != 0 && side[0] == side[1] && side[0] == side[2];
    if (!apart || !(nearer_than < std::numeric_limits<double>::infinity())) return;
    double least = std::numeric_limits<double>::infinity(), rounding = 0;
    for (const Vec3& p : t) {
      const Vec3 d = p - plane.origin;
      least = std::min(least, std::abs(d.dot(plane.normal)));
      rounding = std::max(rounding, d.cwiseAbs().dot(plane.bound));
    }
    const double bound = nearer_than * (1 + determinant_rounding);
    const double sure = least - determinant_rounding * rounding;
    far = sure > 0 && sure * sure > bound * bound * plane.bound.squaredNorm();
  }
};

}  // namespace

NearestPoints nearest_points(const Triangle& a, const Triangle& b, double nearer_than) {
  const PlaneGap over_a(a, b, nearer_than);
  if (over_a.far) return {nearer_than, a[0], b[0]};
  const PlaneGap over_b(b, a, nearer_than);
  if (over_b.far) return {nearer_than, a[0], b[0]};
  if (!over_a.apart && !over_b.apart && triangles_cross(a, b)) return common_point(a, b);
  return points_of(a, b, nearest_candidate(a, b));
}

NearestPoints nearest_points(const Triangle& a, const Triangle& b) {
  return nearest_points(a, b, std::numeric_limits<double>::infinity());
}

}  // namespace brunt::geometry
