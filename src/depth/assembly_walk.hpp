// SPDX-License-Identifier: Apache-2.0
// From a free pose of all members to a local minimum of the motion: walk.hpp for an assembly.
#pragma once
#include "assembly_step.hpp"

namespace brunt::depth {

struct AssemblyWalkOptions {
  double margin = 0;  ///< kept between surfaces [length]
  double trust = 0;   ///< initial value [length]
  int most_steps = 100;
};

class AssemblyWalker {
 public:
  explicit AssemblyWalker(const Standing& standing) : standing_(standing) {}

  /// `start` must be free; the result is free too, and not longer.
  [[nodiscard]] Pose walk(const Pose& start, const AssemblyWalkOptions& options);
  [[nodiscard]] int steps() const { return steps_; }  ///< of all walks

 private:
  void find_conditions(const Pose& pose, double band, double margin);
  [[nodiscard]] bool correct_bounds(const Pose& trial, const SmallMotion& motion, double margin);
  [[nodiscard]] std::optional<Pose> attempt(AssemblyStep& step, const Pose& from, SmallMotion motion, double trust,
                                            double margin, double below);

  const Standing& standing_;
  std::vector<AssemblyCondition> conditions_;
  NearPairs near_;
  int steps_ = 0;
};

}  // namespace brunt::depth
