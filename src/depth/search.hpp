// SPDX-License-Identifier: Apache-2.0
// Walks of one query, from its starts to its answer: many short ones, of which the best are continued.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "depth/starts.hpp"
#include "depth/walk.hpp"

namespace brunt::depth {

/// Many walks at first; after some steps of each only the shortest are continued.
struct Round {
  std::size_t walks, least;  // at most and at least
  int steps;                 // of each
  std::int64_t work;  // upper limit of the work so far (near pairs, and 40 for each step); beyond it only `least` walks
                      // are continued
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
  /// bound: no shorter motion is free [length].
  Search(Encounter& encounter, const Effort& effort, double bound)
      : encounter_(encounter), effort_(effort), bound_(bound) {}

  void walk_from(const RigidMotion& start) { walk_from_all({{start, 0}}); }
  void walk_from_all(const std::vector<Start>& starts);
  /// From the given motion, made free and admissible (a translation has no rotation and only admitted directions).
  void walk_from_placement(const RigidMotion& motion);
  /// A free motion that touches, from another metric: the answer if it is shorter than all others.
  void offer(const RigidMotion& motion);
  /// The motion, made free and admissible; length < 0 if it could not be.
  [[nodiscard]] Start admitted_start(const RigidMotion& motion);
  /// Excludes the work so far from the limits of the following rounds, so that preliminary trials do not reduce their
  /// walks.
  void forget_work() { work_before_ = work(); }
  /// The best answer brought to contact, in the careful mode improved from there with a hundredth of the clearance.
  void finish(bool careful);

  [[nodiscard]] bool done() const;  ///< as short as the bound
  [[nodiscard]] const Start& best() const { return best_; }
  [[nodiscard]] bool found() const { return best_.length < std::numeric_limits<double>::infinity(); }
  /// Ends of the best walks of the last call, the shortest first.
  [[nodiscard]] const std::vector<RigidMotion>& ends() const { return ends_; }
  [[nodiscard]] int walks() const { return walks_; }
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] std::int64_t pairs() const { return walker_.pairs(); }

 private:
  [[nodiscard]] std::int64_t work() const;  ///< near pairs, and `step_work` a step

  Encounter& encounter_;
  Effort effort_;
  double bound_;
  Walker walker_;
  std::vector<RigidMotion> ends_;
  Start best_{{}, std::numeric_limits<double>::infinity()};
  int walks_ = 0, steps_ = 0;
  std::int64_t work_before_ = 0;
};

}  // namespace brunt::depth
