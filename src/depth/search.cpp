// SPDX-License-Identifier: Apache-2.0
#include "search.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::depth {
namespace {

using Rounds = std::array<Round, 3>;

constexpr Rounds fast_rounds{{{32, 4, 3, 4500}, {10, 2, 6, 7500}, {3, 1, 40, 10000}}};
constexpr Rounds careful_rounds{{{100, 40, 5, 80000}, {30, 12, 10, 150000}, {12, 4, 100, 250000}}};
constexpr std::size_t helpful_ends = 4;      // of a metric, as starts of the others
constexpr std::int64_t step_work = 40;       // of a step without pairs, in units of near pairs
constexpr double close_to_bound = 1 + 1e-7;  // an answer this near to the bound needs no further walks
constexpr double near_start = 0.1;           // of the length: starts nearer to each other share a walk

RigidMotion difference(const RigidMotion& one, const RigidMotion& other) {
  return {(other.turn * one.turn.conjugate()).normalized(), other.shift - one.shift};
}

bool shorter_walk(const Walk& x, const Walk& y) {
  return x.length < y.length;
}

}  // namespace

Effort effort_of(Metric metric, bool careful, double clearance, const Mat3& basis) {
  const int grid = metric == Metric::translation ? 2 : 1;  // translations have no rotation to avoid obstacles
  Effort effort{careful ? careful_rounds : fast_rounds, careful ? 3 : grid, careful ? 1e-9 : 1e-7, {}};
  effort.walk.metric = metric;
  effort.walk.clearance = clearance;
  effort.walk.basis = basis;
  if (careful) effort.walk.slope = 1e-3;
  return effort;
}

std::int64_t Search::work() const {
  return walker_.pairs() + step_work * steps_;
}

bool Search::done() const {
  return best_.length <= close_to_bound * bound_;
}

void Search::walk_from_all(const std::vector<Start>& starts) {
  std::vector<Walk> walks;
  for (const Start& start : starts) {
    if (walks.size() >= effort_.rounds[0].walks) break;
    const bool known = std::any_of(walks.begin(), walks.end(), [&](const Walk& other) {
      return length_of(encounter_.a.shape, effort_.walk.metric, difference(start.motion, other.motion)) <
             near_start * start.length;
    });
    if (!known) walks.push_back(Walker::begin(encounter_, start.motion, effort_.walk));
  }
  walks_ += static_cast<int>(walks.size());
  for (const Round& round : effort_.rounds) {
    std::sort(walks.begin(), walks.end(), shorter_walk);
    for (std::size_t i = 0; i < std::min(round.walks, walks.size()) && !done(); ++i) {
      if (i >= round.least && work() - work_before_ > round.work) break;
      Walk& walk = walks[i];
      const int before = walk.steps;
      walker_.advance(encounter_, walk, effort_.walk, round.steps);
      steps_ += walk.steps - before;
      if (walk.length < best_.length) best_ = {walk.motion, walk.length};
    }
  }
  std::sort(walks.begin(), walks.end(), shorter_walk);
  ends_.clear();
  for (std::size_t i = 0; i < std::min(helpful_ends, walks.size()); ++i) ends_.push_back(walks[i].motion);
}

Start Search::admitted_start(const RigidMotion& motion) {
  if (effort_.walk.metric != Metric::translation) return freed(encounter_, effort_.walk.metric, motion);
  const Mat3& basis = effort_.walk.basis;
  return freed(encounter_, Metric::translation,
               {Eigen::Quaterniond::Identity(), basis * (basis.transpose() * motion.shift)});
}

void Search::walk_from_placement(const RigidMotion& motion) {
  const Start start = admitted_start(motion);
  if (start.length > 0) walk_from(start.motion);
}

void Search::offer(const RigidMotion& motion) {
  if (effort_.walk.metric == Metric::translation && motion.turn.vec().squaredNorm() > 0) return;
  const double length = length_of(encounter_.a.shape, effort_.walk.metric, motion);
  if (length < best_.length) best_ = {motion, length};
}

void Search::finish(bool careful) {
  const double radius = encounter_.a.shape.radius;
  const Metric metric = effort_.walk.metric;
  const auto length = [&](const RigidMotion& motion) { return length_of(encounter_.a.shape, metric, motion); };
  best_.motion = pulled(encounter_, metric, best_.motion, effort_.pull * radius);
  if (careful) {
    WalkOptions fine = effort_.walk;
    fine.clearance *= 1e-2;
    fine.slope = 1e-7;
    fine.least_trust = 1e-8;
    const Start start = freed(encounter_, metric, along_screw(best_.motion, 1 + 1e-7));
    if (start.length > 0) {
      Walk walk = Walker::begin(encounter_, start.motion, fine);
      walker_.advance(encounter_, walk, fine, 200);
      steps_ += walk.steps;
      const RigidMotion motion = pulled(encounter_, metric, walk.motion, effort_.pull * radius);
      if (length(motion) < length(best_.motion)) best_.motion = motion;
    }
  }
  best_.length = length(best_.motion);
}

}  // namespace brunt::depth
