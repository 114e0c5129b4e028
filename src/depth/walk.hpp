// SPDX-License-Identifier: Apache-2.0
// A walk (descent) from a free placement along the contact space to a placement from which no small motion is shorter:
// the method of Zhang, Kim, Manocha (2007) as sequential programming on close pairs, the same for all metrics.
//
// Step: conditions of the pairs closer than a quarter of the trust region; the best small motion under them; accepted
// if it is free and shorter. If it collides (curvature of rotations, pairs beyond the band), it is moved slightly
// outwards along its own screw from q_0, and accepted if it is still shorter; otherwise the trust region is reduced.
// The walk ends when the linear model predicts no decrease. Every accepted placement is free, so the length is an upper
// bound.
#pragma once
#include "depth/local_step.hpp"

namespace brunt::depth {

struct WalkOptions {
  Metric metric = Metric::displacement;
  double clearance = 1e-6;        ///< kept between the surfaces, in units of A's radius
  double slope = 3e-3;            ///< ends when the predicted decrease is below this share of the trust region
  double least_trust = 1e-3;      ///< ends when the trust region is below this share of the length
  Mat3 basis = Mat3::Identity();  ///< of admitted translations, see LocalProblem
};

/// A walk that may be interrupted.
struct Walk {
  RigidMotion motion;  ///< free
  double length = 0;
  double trust = 0, band = 0;  ///< [length]
  int steps = 0;
  bool ended = false;
};

class Walker {
 public:
  /// Begins at a free placement.
  [[nodiscard]] static Walk begin(const Encounter& encounter, const RigidMotion& start, const WalkOptions& options);
  /// At most this number of further steps.
  void advance(Encounter& encounter, Walk& walk, const WalkOptions& options, int most_steps);
  [[nodiscard]] std::int64_t pairs() const { return pairs_; }  ///< close pairs found so far: a measure of work
  [[nodiscard]] std::span<const NearCondition> conditions() const { return near_.conditions; }

 private:
  struct Trial {
    RigidMotion motion;
    double length = 0;
    bool accepted = false;
  };
  Trial attempt(Encounter& encounter, const RigidMotion& from, LocalStep step, const LocalProblem& problem,
                double margin, double below);
  std::int64_t pairs_ = 0;
  NearPairs near_;
  LocalSolver solver_;
};

/// Moves back along the screw towards q_0 by bisection, to a free placement within `accuracy` [length] of a colliding
/// one. `motion` must be free.
[[nodiscard]] RigidMotion pulled(Encounter& encounter, Metric metric, const RigidMotion& motion, double accuracy);

}  // namespace brunt::depth
