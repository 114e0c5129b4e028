// SPDX-License-Identifier: Apache-2.0
#include "brunt/depth/walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double first_trust = 0.25;  // of the length
constexpr double most_trust = 0.5;    // of the length
constexpr double band_share = 0.1;    // of the trust region: wider bands cost ten times more for the same results
constexpr double widen = 3;           // of the band, where the step collides with what lies beyond it
constexpr double wide_band = 0.25;    // of the trust region: no wider ones
constexpr double cut_share = 0.1;     // of the decrease that ends a walk: accuracy of the least DISP
constexpr double least_band = 4;      // of the clearance
constexpr std::array<double, 2> outward{0.02, 0.08};  // shares of the trust region for a placement that collides
constexpr int corrections = 2;                        // of second order, of one step
constexpr double shrink = 0.4, grow = 2;
constexpr double good = 0.7, poor = 0.2;  // actual decrease over predicted one: grow, shrink

}  // namespace

/// The step itself, or corrected to second order, or moved outwards.
Walker::Trial Walker::attempt(Encounter& encounter, const RigidMotion& from, LocalStep step,
                              const LocalProblem& problem, double margin, double below) {
  const MetricShape& shape = encounter.a.shape;
  Trial trial{step.motion, length_of(shape, problem.metric, step.motion), false};
  for (int i = 0;; ++i) {
    if (!(trial.length < below)) return trial;
    if (!encounter.collides(trial.motion)) {
      trial.accepted = true;
      return trial;
    }
    if (i == corrections || !correct_bounds(encounter, step.motion, step.tau, step.omega, margin, near_.conditions))
      break;
    step = solver_.solve(shape, from, near_.conditions, problem);
    if (!step.solved) break;
    trial = {step.motion, length_of(shape, problem.metric, step.motion), false};
  }
  for (const double push : outward) {
    const RigidMotion out = along_screw(trial.motion, 1 + push * problem.trust / trial.length);
    const double length = length_of(shape, problem.metric, out);
    if (!(length < below)) break;
    if (!encounter.collides(out)) return {out, length, true};
  }
  return trial;
}

WalkResult Walker::walk(Encounter& encounter, const RigidMotion& start, const WalkOptions& options) {
  const MetricShape& shape = encounter.a.shape;
  WalkResult result{start, length_of(shape, options.metric, start), 0, false};
  LocalProblem problem;
  problem.metric = options.metric;
  const double margin = options.clearance * shape.radius;
  problem.trust = first_trust * result.length;
  problem.basis = options.basis;
  double band = 0, share = band_share;
  bool fresh = true;  // conditions are of another placement or a narrower band
  for (; result.steps < options.most_steps; ++result.steps) {
    if (problem.trust < options.least_trust * result.length) break;
    if (fresh) {
      band = std::max(share * problem.trust, least_band * margin);
      near_.find(encounter, result.motion, band, margin);
    } else {
      near_.forget_corrections(margin);
    }
    problem.accuracy = cut_share * options.slope * problem.trust;
    const LocalStep step = solver_.solve(shape, result.motion, near_.conditions, problem);
    const double predicted = result.length - step.predicted;
    if (step.solved && predicted <= options.slope * problem.trust) {
      result.stationary = true;
      break;
    }
    const Trial trial = step.solved ? attempt(encounter, result.motion, step, problem, margin, result.length) : Trial{};
    if (!trial.accepted) {
      fresh = band < wide_band * problem.trust;
      if (fresh)
        share *= widen;
      else
        problem.trust = shrink * (step.solved ? std::min(problem.trust, step.size) : problem.trust);
      continue;
    }
    const double gain = (result.length - trial.length) / predicted;
    if (gain > good) problem.trust = std::min(grow * problem.trust, most_trust * trial.length);
    if (gain < poor) problem.trust *= shrink;
    result.motion = trial.motion;
    result.length = trial.length;
    fresh = true;
    share = band_share;
  }
  return result;
}

RigidMotion pulled(Encounter& encounter, Metric metric, const RigidMotion& motion, double accuracy) {
  const double length = length_of(encounter.a.shape, metric, motion);
  if (!(length > accuracy)) return motion;
  double free = 1, collides = 0, step = std::min(0.5, 4 * accuracy / length);
  const double end = accuracy / length;
  while (free - collides > end) {
    const double s = collides > 0 ? 0.5 * (free + collides) : std::max(0.0, free - step);
    if (s <= 0 || encounter.collides(along_screw(motion, s))) {
      if (s <= 0) break;
      collides = s;
    } else {
      free = s;
      step *= 4;
    }
  }
  return along_screw(motion, free);
}

}  // namespace brunt::depth
