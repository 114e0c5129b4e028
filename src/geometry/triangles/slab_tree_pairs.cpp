// SPDX-License-Identifier: Apache-2.0
// Pairs of triangles of two surfaces: the first that cross, all that are near, the nearest.
#include <algorithm>
#include <cmath>

#include "slab_walk.hpp"

namespace brunt::geometry {

bool surfaces_cross(const SlabTree& a, const SlabTree& b, const Placement& a_in_b) {
  auto visit = [&](LocalIndex /*of_a*/, const Triangle& corners, LocalIndex j) {
    return triangles_cross(corners, nth(b.triangles, j));
  };
  return SlabWalk(a, b, a_in_b, 0, visit).run();
}

void near_pairs(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double band,
                std::vector<NearPair>& out) {
  out.clear();
  auto visit = [&](LocalIndex i, const Triangle& corners, LocalIndex j) {
    const NearestPoints nearest = nearest_points(corners, nth(b.triangles, j), band);
    if (nearest.distance < band) out.push_back({i, j, nearest.distance, nearest.on_a, nearest.on_b});
    return false;
  };
  SlabWalk(a, b, a_in_b, band, visit).run();
  std::sort(out.begin(), out.end(),
            [](const NearPair& p, const NearPair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
}

double surface_distance(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double at_most) {
  struct Visit {
    const SlabTree& b;
    double least;
    SlabWalk<Visit>* walk = nullptr;
    bool operator()(LocalIndex /*of_a*/, const Triangle& corners, LocalIndex j) {
      const double distance = nearest_points(corners, nth(b.triangles, j), least).distance;
      if (distance < least) {
        least = distance;
        walk->set_limit(least);
      }
      return least == 0;
    }
  } visit{b, at_most};
  SlabWalk<Visit> walk(a, b, a_in_b, at_most, visit);
  visit.walk = &walk;
  walk.run();
  return visit.least;
}

}  // namespace brunt::geometry
