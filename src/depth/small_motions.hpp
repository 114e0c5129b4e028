// SPDX-License-Identifier: Apache-2.0
// Free placements near q_0: small motions, one after the other, that take the linear conditions of overlap_rows.hpp as
// far as they go. Bodies that fit into each other are apart after a few; marches in straight lines do not find that.
//
// Unknowns (tau, rho omega, t): least rms of the whole motion, plus a large multiple of t^2, under
//   n . (tau + omega x arm) + t >= bound   and   |xi_i| <= trust.
// t is the overlap that is left, so the program always has a solution. Where the conditions contradict each other, t
// stays, and the attempt ends.
#pragma once
#include <vector>

#include "depth/quadratic_program.hpp"
#include "depth/starts.hpp"
#include "overlap_rows.hpp"

namespace brunt::depth {

/// What the small motions consist of.
enum class Freedom { shift, turn, both };

class SmallMotions {
 public:
  /// basis: of admitted translations, see LocalProblem. margin: distance to be left between the surfaces; bound: no
  /// shorter motion is free [length].
  SmallMotions(Encounter& encounter, const Mat3& basis, double margin, double bound);

  /// From the motion `from`, at which the bodies may overlap; length < 0 if they still do in the end. First without the
  /// pairs that overlap by much more than the bound, then with all.
  [[nodiscard]] Start find(const RigidMotion& from, Freedom freedom, Metric metric);
  /// The depth of the overlap at q_0 as pairs of triangles show it [length].
  [[nodiscard]] double overlap() const { return overlap_; }
  [[nodiscard]] double sum_of_overlaps() const { return sum_; }  ///< of separate regions [length]

 private:
  [[nodiscard]] Start attempt(const RigidMotion& from, Freedom freedom, Metric metric, double most);
  RigidMotion step(const RigidMotion& from, Freedom freedom, double trust);

  Encounter& encounter_;
  Mat3 basis_;
  double margin_, usual_, overlap_ = 0, sum_ = 0;
  OverlapRows rows_;
  std::vector<Row<7>> program_;
};

}  // namespace brunt::depth
