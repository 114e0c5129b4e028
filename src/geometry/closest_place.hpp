// SPDX-License-Identifier: Apache-2.0
// closest_point for a pack of points on one quadrilateral each. Cases that the usual procedures do not settle (Newton's
// method after a few steps, or an edge where it ends outside) are left to closest_point itself. Which lanes these are,
// and the results of the others, depend on each lane only.
#pragma once
#include "geometry/vec_of.hpp"

namespace brunt::geometry {

/// A pack of quadrilaterals, counter-clockwise seen from outside.
struct PackQuad {
  PackVec corner[4];
};

/// Of the corners at (xi, eta), sum 1.
struct PackWeights {
  Pack of[4];
};

BRUNT_INLINE PackWeights quad_weights(Pack xi, Pack eta) {
  return {{0.25 * (1 - xi) * (1 - eta), 0.25 * (1 + xi) * (1 - eta), 0.25 * (1 + xi) * (1 + eta),
           0.25 * (1 - xi) * (1 + eta)}};
}

BRUNT_INLINE PackVec combine(const PackQuad& quad, const PackWeights& weights) {
  PackVec sum = weights.of[0] * quad.corner[0];
  for (int i = 1; i < 4; ++i) sum = sum + weights.of[i] * quad.corner[i];
  return sum;
}

struct PackTangents {
  PackVec xi, eta;
};

BRUNT_INLINE PackTangents tangents(const PackQuad& quad, Pack xi, Pack eta) {
  const PackVec(&c)[4] = quad.corner;
  const Pack quarter = broadcast(0.25);
  return {quarter * ((1 - eta) * (c[1] - c[0]) + (1 + eta) * (c[2] - c[3])),
          quarter * ((1 - xi) * (c[3] - c[0]) + (1 + xi) * (c[2] - c[1]))};
}

/// The positions of the closest points.
struct PackPlace {
  Pack xi, eta;
  PackMask known;    ///< lanes that are settled; the others need closest_point
  PackMask on_face;  ///< of these: projects on the face; the others lie on its rim:
  Pack edge;         ///< 0, 1, 2, 3: the edge of the rim,
  Pack along;        ///< and where on it, 0 to 1
};

PackPlace closest_place(const PackVec& x, const PackQuad& quad);

}  // namespace brunt::geometry
