// SPDX-License-Identifier: Apache-2.0
// The largest sum of a point's depths in both bodies, or the quotient that bounds the object norm.
//
// Inside a body the depth is the minimum of the distances to its triangles, each a convex function. A local maximum of
// the sum is therefore a corner of the linear model of the triangles found so far, and steps to the model's maximum
// converge quadratically (a proximal bundle method: K. C. Kiwiel, Methods of Descent for Nondifferentiable
// Optimization, 1985). The step is bounded by an isotropic quadratic term, so that paths rotate with the bodies.
#pragma once
#include <vector>

#include "depth/encounter.hpp"
#include "depth/quadratic_program.hpp"

namespace brunt::depth {

/// A point with its depths in both bodies.
struct SeenPoint {
  Vec3 y = Vec3::Zero();            ///< coordinates of B
  Vec3 in_a = Vec3::Zero();         ///< the same point in those of A
  geometry::PointDepth a, b;        ///< in their own coordinates
  double sum = 0;                   ///< phi_A + phi_B, and the required distance [length]
  double scale = 1;                 ///< value = sum / scale
  Vec3 scale_slope = Vec3::Zero();  ///< gradient of the scale, coordinates of B
  double value = 0;                 ///< the bound [length]
};

class DepthAscent {
 public:
  DepthAscent(const Encounter& encounter, Metric metric);

  /// Ascends to a local maximum, within rounding, if it needs at most this number of depth queries.
  [[nodiscard]] SeenPoint climb(SeenPoint centre, int most_looks);
  [[nodiscard]] SeenPoint look(const Vec3& y) const;
  /// Divisor of the sum: 1, in the object norm the root of the point's factor.
  [[nodiscard]] double scale_of(const Vec3& in_a) const;

 private:
  bool keep_triangles(const SeenPoint& seen);
  void lay_rows(const SeenPoint& centre, double size);
  void lay_rows_of(const geometry::SlabTree& tree, std::vector<LocalIndex>& list, const Vec3& x,
                   const geometry::PointDepth& here, int unknown, const Mat3& out, double size);

  const Encounter& encounter_;
  Metric metric_;
  Mat3 inverse_gyration_;
  std::vector<LocalIndex> of_a_, of_b_;  // triangles found so far
  std::vector<Row<5>> rows_;             // of a step and the two depths there, in units of the step's size
};

}  // namespace brunt::depth
