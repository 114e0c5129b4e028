// SPDX-License-Identifier: Apache-2.0
// Many walks, of which the shortest go on: what one query does between its starts and its answer.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "brunt/depth/starts.hpp"
#include "brunt/depth/walk.hpp"

namespace brunt::depth {

/// Walks are many at first; after some steps of each the shortest go on.
struct Round {
  std::size_t walks, least;  // at most and at least
  int steps;                 // of each
  std::int64_t work;         // found so far (near pairs, and 40 a step): with more than this only `least` walks go on
};

struct Effort {
  std::array<Round, 3> rounds;
  int grid;     // of directions, see StartOptions
  double pull;  // accuracy of the final contact, in units of A's radius
  WalkOptions walk;
};

[[nodiscard]] Effort effort_of(Metric metric, bool careful, double clearance, const Mat3& basis);

class Search {
 public:
  /// bound: nothing shorter is free [length].
  Search(Encounter& encounter, const Effort& effort, double bound)
      : encounter_(encounter), effort_(effort), bound_(bound) {}

  void walk_from(const RigidMotion& start) { walk_from_all({{start, 0}}); }
  void walk_from_all(const std::vector<Start>& starts);
  /// From the motion, made free and admitted (a translation has no rotation and only admitted directions).
  void walk_from_placement(const RigidMotion& motion);
  /// Walks in the other metrics, and from where they end in the own one.
  void help_by_other_metrics(const std::vector<Start>& starts);
  /// What was done so far does not count against the work of the rounds that follow: what is tried first takes nothing
  /// from the walks after it.
  void forget_work() { work_before_ = work(); }
  /// The best answer brought to contact, and in the careful mode improved from there with a hundredth of the clearance.
  void finish(bool careful);

  [[nodiscard]] bool done() const;  ///< as short as the bound
  [[nodiscard]] const Start& best() const { return best_; }
  [[nodiscard]] bool found() const { return best_.length < std::numeric_limits<double>::infinity(); }
  [[nodiscard]] int walks() const { return walks_; }
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] std::int64_t pairs() const { return pairs_ + walker_.pairs(); }

 private:
  [[nodiscard]] std::int64_t work() const;  ///< near pairs, and `step_work` a step
  [[nodiscard]] Start admitted_start(const RigidMotion& motion);

  Encounter& encounter_;
  Effort effort_;
  double bound_;
  Walker walker_;
  std::vector<RigidMotion> ends_;  // where the best walks of the last call ended, the shortest first
  Start best_{{}, std::numeric_limits<double>::infinity()};
  int walks_ = 0, steps_ = 0;
  std::int64_t pairs_ = 0, work_before_ = 0;
};

}  // namespace brunt::depth
