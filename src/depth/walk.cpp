// SPDX-License-Identifier: Apache-2.0
#include "depth/walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double first_trust = 0.25;  // of the length
constexpr double most_trust = 0.5;    // of the length
constexpr double band_share = 0.1;    // of the trust region: wider bands cost ten times as much for equal results
constexpr double widen = 3;           // of the band, if the step collides with features beyond it
constexpr double narrow = 0.4;        // of the band, after an accepted step
constexpr double wide_band = 0.25;    // of the step: upper bound, except
constexpr double enough_pairs = 60;   // conditions: with more the next band is narrower
constexpr double whole_reach = 3;     // of the step, if no pair is in the band
constexpr double cut_share = 0.1;     // of the decrease that ends a walk: accuracy of the least DISP
constexpr double least_band = 4;      // of the clearance
constexpr std::array<double, 2> outward{0.02, 0.08};  // shares of the trust region for a placement that collides
constexpr int corrections = 2;                        // of second order, for one step
constexpr std::array<double, 4> grazes{1e-6, 1e-5, 1e-4, 1e-3};  // of the screw: positions tested beyond a contact
constexpr int most_grazes = 8;
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

Walk Walker::begin(const Encounter& encounter, const RigidMotion& start, const WalkOptions& options) {
  Walk walk;
  walk.motion = start;
  walk.length = length_of(encounter.a.shape, options.metric, start);
  walk.trust = first_trust * walk.length;
  walk.band = band_share * walk.trust;
  return walk;
}

void Walker::advance(Encounter& encounter, Walk& walk, const WalkOptions& options, int most_steps) {
  const MetricShape& shape = encounter.a.shape;
  const double clearance = options.clearance * shape.radius, margin = encounter.apart + clearance;
  LocalProblem problem;
  problem.metric = options.metric;
  problem.basis = options.basis;
  problem.axes = encounter.a.axes;
  bool fresh = true;  // conditions belong to another placement or a narrower band
  for (const int end = walk.steps + most_steps; !walk.ended && walk.steps < end; ++walk.steps) {
    walk.ended = walk.trust < options.least_trust * walk.length;
    if (walk.ended) return;
    if (fresh) {
      walk.band = std::max(walk.band, least_band * clearance);
      near_.find(encounter, walk.motion, encounter.apart + walk.band, margin);
      pairs_ += static_cast<std::int64_t>(near_.pairs.size());
    } else {
      near_.forget_corrections(margin);
    }
    problem.trust = walk.trust;
    problem.accuracy = cut_share * options.slope * walk.trust;
    const LocalStep step = solver_.solve(shape, walk.motion, near_.conditions, problem);
    const double predicted = walk.length - step.predicted;
    walk.ended = step.solved && predicted <= options.slope * walk.trust;
    if (walk.ended) return;
    const Trial trial = step.solved ? attempt(encounter, walk.motion, step, problem, margin, walk.length) : Trial{};
    if (!trial.accepted) {
      fresh = walk.band < (near_.conditions.empty() ? whole_reach : wide_band) * step.size;
      if (fresh)
        walk.band *= widen;
      else
        walk.trust = shrink * (step.solved ? std::min(walk.trust, step.size) : walk.trust);
      continue;
    }
    const double gain = (walk.length - trial.length) / predicted;
    if (gain > good) walk.trust = std::min(grow * walk.trust, most_trust * trial.length);
    if (gain < poor) walk.trust *= shrink;
    walk.motion = trial.motion;
    walk.length = trial.length;
    fresh = true;
    const double crowd = std::max(1.0, static_cast<double>(near_.conditions.size()) / enough_pairs);
    walk.band = std::max(narrow * walk.band, band_share * walk.trust) / crowd;
  }
}

namespace {

/// The least s up to `free` that is free and above a colliding one within `end`.
double pulled_share(Encounter& encounter, const RigidMotion& motion, double free, double end) {
  double collides = 0, step = std::min(0.5, 4 * end);
  while (free - collides > end) {
    const double s = collides > 0 ? 0.5 * (free + collides) : std::max(0.0, free - step);
    if (s <= 0) break;
    if (encounter.collides(along_screw(motion, s))) {
      collides = s;
    } else {
      free = s;
      step *= 4;
    }
  }
  return free;
}

}  // namespace

RigidMotion pulled(Encounter& encounter, Metric metric, const RigidMotion& motion, double accuracy) {
  const double length = length_of(encounter.a.shape, metric, motion);
  if (!(length > accuracy)) return motion;
  double free = 1;
  for (int i = 0; i < most_grazes; ++i) {
    free = pulled_share(encounter, motion, free, accuracy / length);
    // grazing features collide only on a short part of the screw
    const auto* beyond = std::find_if(grazes.begin(), grazes.end(), [&](double share) {
      return !encounter.collides(along_screw(motion, free * (1 - share)));
    });
    if (beyond == grazes.end()) break;
    free *= 1 - *beyond;
  }
  return along_screw(motion, free);
}

}  // namespace brunt::depth
