// SPDX-License-Identifier: Apache-2.0
// Linear conditions on a small motion of A at a placement where the bodies overlap: after it they would not.
//
// A pair of triangles that cross is parted by a plane: that of one of them, or one along an edge of each, of those
// that both surfaces have as a tangent plane there (A leaves B on B's outer side and on its own). The plane with the
// smallest overlap g is taken. With its normal n from B to A, n . x = h, every corner of what lies of the other
// triangle over the face gives
//   n . (tau + omega x (x - c)) >= g(x) + margin,
// also for a plane that moves with A (the terms of its rotation are the same in first order). A vertex of one body
// inside the other gives the same with its nearest point of the surface. Pairs that do not cross give the conditions of
// near_pairs.hpp, unless their nearest points look at each other through one of the bodies: these have passed through.
#pragma once
#include <vector>

#include "depth/near_pairs.hpp"

namespace brunt::depth {

struct OverlapRows {
  std::vector<NearCondition> conditions;  ///< in the axes of A at q_0; bounds above 0 where the bodies overlap
  double deepest = 0;                     ///< the greatest bound [length]

  /// band: pairs and corners at greater distances, and vertices that are deeper, give no condition; most: nor do pairs
  /// that overlap by more, which the chosen plane does not part well [length].
  void find(const Encounter& encounter, const RigidMotion& motion, double band, double margin, double most);
  /// Overlaps of pairs that cross, of each region the greatest: crossing pairs with a common triangle are of one region
  /// [length].
  [[nodiscard]] double sum_of_regions() const;

 private:
  struct Place;
  void add(const Place& place, const Vec3& normal, const Vec3& at, double gap);
  void part(const Place& place, const geometry::NearPair& pair);
  void free_vertices(const Place& place);
  void merge(double grid);
  void free_vertex(const Place& place, const Vec3& x, bool of_a);

  std::vector<geometry::NearPair> pairs_;
  std::vector<LocalIndex> crossing_a_, crossing_b_;  // triangles of pairs that cross
  std::vector<double> overlaps_;                     // of the same pairs, 0 if no plane parts them
};

}  // namespace brunt::depth
