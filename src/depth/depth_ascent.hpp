// SPDX-License-Identifier: Apache-2.0
// The greatest sum of a point's depths in both bodies, or its share that bounds the object norm.
//
// Inside a body the depth is the least of the distances to its triangles, each a convex function. So a local maximum of
// the sum is a corner of the linear model made of the triangles seen so far, and steps to the model's maximum converge
// quadratically (a proximal bundle method: K. C. Kiwiel, Methods of Descent for Nondifferentiable Optimization, 1985).
// The step's size is held by an isotropic quadratic term: paths turn with the bodies.
#pragma once
#include <vector>

#include "brunt/depth/encounter.hpp"
#include "brunt/depth/quadratic_program.hpp"

namespace brunt::depth {

/// A point with its depths in both bodies.
struct SeenPoint {
  Vec3 y = Vec3::Zero();            ///< coordinates of B
  Vec3 in_a = Vec3::Zero();         ///< the same point in those of A
  geometry::PointDepth a, b;        ///< in their own coordinates
  double sum = 0;                   ///< phi_A + phi_B, and what is to be left between them [length]
  double scale = 1;                 ///< value = sum / scale
  Vec3 scale_slope = Vec3::Zero();  ///< gradient of the scale, coordinates of B
  double value = 0;                 ///< the bound [length]
};

class DepthAscent {
 public:
  DepthAscent(const Encounter& encounter, Metric metric);

  /// To a local maximum, within rounding, if that needs no more than so many looks.
  [[nodiscard]] SeenPoint climb(SeenPoint centre, int most_looks);
  [[nodiscard]] SeenPoint look(const Vec3& y) const;
  /// By which the sum is divided: 1, but in the object norm the root of the point's factor.
  [[nodiscard]] double scale_of(const Vec3& in_a) const;

 private:
  bool keep_triangles(const SeenPoint& seen);
  void lay_rows(const SeenPoint& centre, double size);
  void lay_rows_of(const geometry::SlabTree& tree, std::vector<LocalIndex>& list, const Vec3& x,
                   const geometry::PointDepth& here, int unknown, const Mat3& out, double size);

  const Encounter& encounter_;
  Metric metric_;
  Mat3 inverse_gyration_;
  std::vector<LocalIndex> of_a_, of_b_;  // triangles seen
  std::vector<Row<5>> rows_;             // of a step and the two depths there, in units of the step's size
};

}  // namespace brunt::depth
