// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "brunt/geometry/slab_tree.hpp"

namespace brunt::geometry {
namespace {

Triangle placed(const Triangle& t, const Placement& placement) {
  return {placement(t[0]), placement(t[1]), placement(t[2])};
}

}  // namespace

bool surfaces_cross(const SlabTree& a, const SlabTree& b, const Placement& a_in_b) {
  for (const Triangle& t : a.triangles) {
    const Triangle moved = placed(t, a_in_b);
    for (const Triangle& other : b.triangles)
      if (triangles_cross(moved, other)) return true;
  }
  return false;
}

void near_pairs(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double band,
                std::vector<NearPair>& out) {
  out.clear();
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    const Triangle moved = placed(a.triangles[i], a_in_b);
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      const NearestPoints nearest = nearest_points(moved, b.triangles[j], band);
      if (nearest.distance < band)
        out.push_back(
            {static_cast<LocalIndex>(i), static_cast<LocalIndex>(j), nearest.distance, nearest.on_a, nearest.on_b});
    }
  }
}

double surface_distance(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double at_most) {
  double least = at_most;
  for (const Triangle& t : a.triangles) {
    const Triangle moved = placed(t, a_in_b);
    for (const Triangle& other : b.triangles) least = std::min(least, nearest_points(moved, other, least).distance);
  }
  return least;
}

}  // namespace brunt::geometry
