// SPDX-License-Identifier: Apache-2.0
// The least translations of all members under separating planes of pairs.
#pragma once
#include <vector>

#include "assembly_pose.hpp"

namespace brunt::depth {

struct Plane {
  std::size_t pair = 0;
  Vec3 along = Vec3::Zero();  ///< unit, from b to a
  double bound = 0;           ///< of along . (x_a - x_b), x the translations from the start [length]
};

class PlaneProgram {
 public:
  explicit PlaneProgram(const Standing& standing);

  /// Sets the translations of the pose; false if there is no solution: `proof` then contains contradictory planes, if
  /// known.
  bool solve(const std::vector<Plane>& planes, Pose& pose, std::vector<std::size_t>& proof) const;

 private:
  struct Unknown {
    std::size_t member;
    Vec3 axis;
  };
  const Standing& standing_;
  std::vector<Unknown> unknowns_;
};

}  // namespace brunt::depth
