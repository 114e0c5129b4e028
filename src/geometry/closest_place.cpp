// SPDX-License-Identifier: Apache-2.0
// The steps are those of closest_point.cpp: changes must be made in both.
#include "geometry/closest_place.hpp"

#include <limits>

#include "geometry/closest_point.hpp"

namespace brunt::geometry {
namespace {

BRUNT_INLINE Pack clamped(Pack a, double low, double high) {
  return pack_min(pack_max(a, broadcast(low)), broadcast(high));
}

/// Newton's iterates, lane by lane.
struct Iterate {
  Pack xi, eta;
  PackMask running;  ///< not yet converged
  PackMask settled;  ///< lanes with neither flag have failed
};

BRUNT_INLINE Pack edge_area(const PackVec& x, const PackVec& from, const PackVec& to, const PackVec& normal) {
  return dot(normal, cross(to - from, x - from));
}

BRUNT_INLINE Pack area_ratio(Pack low_side, Pack high_side) {
  const Pack sum = low_side + high_side;
  return select(sum > 0, clamped((low_side - high_side) / sum, -1.5, 1.5), broadcast(0.0));
}

/// The start of the iteration; lanes without area, or with values that are not finite, fail at once.
BRUNT_INLINE Iterate seed(const PackVec& x, const PackQuad& quad) {
  const PackVec(&c)[4] = quad.corner;
  const PackVec area = broadcast(0.5) * cross(c[2] - c[0], c[3] - c[1]);
  Pack edge2 = broadcast(0.0);
  for (int i = 0; i < 4; ++i) {
    const PackVec edge = c[(i + 1) % 4] - c[i];
    edge2 = pack_max(edge2, dot(edge, edge));
  }
  const double finite = std::numeric_limits<double>::max();
  const PackMask good = (dot(area, area) > 1e-24 * edge2 * edge2) & (pack_abs(x.x) <= finite) &
                        (pack_abs(x.y) <= finite) & (pack_abs(x.z) <= finite);
  return {area_ratio(edge_area(x, c[3], c[0], area), edge_area(x, c[1], c[2], area)),
          area_ratio(edge_area(x, c[0], c[1], area), edge_area(x, c[2], c[3], area)), good, PackMask{}};
}

BRUNT_INLINE void newton_step(const PackVec& x, const PackQuad& quad, const PackVec& twist, PackMask nearly_flat,
                              Iterate& p) {
  constexpr double lost = 4.0;
  const PackTangents t = tangents(quad, p.xi, p.eta);
  const PackVec offset = x - combine(quad, quad_weights(p.xi, p.eta));
  const Pack a = dot(t.xi, t.xi), b = dot(t.eta, t.eta);
  Pack mixed = dot(t.xi, t.eta) - dot(offset, twist);
  const PackMask convex = a * b - mixed * mixed > 0.05 * a * b;  // otherwise Gauss-Newton
  mixed = select(convex, mixed, dot(t.xi, t.eta));
  const Pack settled = select(convex, broadcast(1e-7), broadcast(1e-13));
  const Pack determinant = a * b - mixed * mixed;
  const PackMask solvable = determinant > 1e-12 * a * b;
  const Pack f = dot(t.xi, offset), g = dot(t.eta, offset);
  const Pack d_xi = (b * f - mixed * g) / determinant, d_eta = (a * g - mixed * f) / determinant;
  p.xi = select(p.running, p.xi + d_xi, p.xi);
  p.eta = select(p.running, p.eta + d_eta, p.eta);
  const PackMask here = (pack_abs(p.xi) < lost) & (pack_abs(p.eta) < lost);
  const double finite = std::numeric_limits<double>::max();
  const PackMask far_outside = ~here & nearly_flat & (pack_abs(p.xi) <= finite) & (pack_abs(p.eta) <= finite);
  const PackMask small = pack_abs(d_xi) + pack_abs(d_eta) < settled;
  p.settled |= p.running & solvable & (far_outside | (here & small));
  p.running &= solvable & here & ~small;
}

BRUNT_INLINE Iterate newton(const PackVec& x, const PackQuad& quad) {
  constexpr int most_steps = 5;  // the few points that need more are left to closest_point
  const PackVec(&c)[4] = quad.corner;
  const PackVec twist = broadcast(0.25) * ((c[0] - c[1]) + (c[2] - c[3]));
  const PackTangents middle = tangents(quad, broadcast(0.0), broadcast(0.0));
  const PackMask nearly_flat =
      dot(twist, twist) < 0.01 * pack_min(dot(middle.xi, middle.xi), dot(middle.eta, middle.eta));
  Iterate p = seed(x, quad);
  for (int step = 0; step < most_steps && any(p.running); ++step) newton_step(x, quad, twist, nearly_flat, p);
  return p;
}

/// The nearest point of the boundary, in place of the result of the iteration.
BRUNT_INLINE void to_rim(const PackVec& x, const PackQuad& quad, PackPlace& place) {
  Pack least = broadcast(std::numeric_limits<double>::infinity());
  place.edge = place.along = broadcast(0.0);
  for (int edge = 0; edge < 4; ++edge) {
    const PackVec &from = quad.corner[edge], &to = quad.corner[(edge + 1) % 4];
    const PackVec way = to - from;
    const Pack length2 = dot(way, way);
    const Pack along = select(length2 > 0, clamped(dot(x - from, way) / length2, 0.0, 1.0), broadcast(0.0));
    const PackVec apart = x - ((1 - along) * from + along * to);
    const Pack distance2 = dot(apart, apart);
    const Pack rank = select((along > 0) & (along < 1), distance2, distance2 * (1 + 1e-15));
    const PackMask nearer = rank < least;
    least = select(nearer, rank, least);
    place.along = select(nearer, along, place.along);
    place.edge = select(nearer, broadcast(edge), place.edge);
  }
  const Pack s = 2 * place.along - 1, one = broadcast(1.0);
  const Pack xi = select(place.edge < 1, s, select(place.edge < 2, one, select(place.edge < 3, -s, -one)));
  const Pack eta = select(place.edge < 1, -one, select(place.edge < 2, s, select(place.edge < 3, one, -s)));
  place.xi = select(place.on_face, place.xi, xi);
  place.eta = select(place.on_face, place.eta, eta);
}

}  // namespace

PackPlace closest_place(const PackVec& x, const PackQuad& quad) {
  constexpr double reach = 1 + 2 * face_tolerance;  // the parametric width is 2
  const Iterate p = newton(x, quad);
  PackPlace place{clamped(p.xi, -1, 1), clamped(p.eta, -1, 1), p.settled, {}, Pack{}, Pack{}};
  place.on_face = p.settled & (pack_abs(p.xi) <= reach) & (pack_abs(p.eta) <= reach);
  if (any(place.known & ~place.on_face)) to_rim(x, quad, place);
  return place;
}

}  // namespace brunt::geometry
