// SPDX-License-Identifier: Apache-2.0
#include "assembly_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double band_share = 0.1;  // of the trust region; wider if the step collides with features beyond it
constexpr double widen = 3;         // factor of the band in that case
constexpr double wide_band = 2;     // of the trust region: the reach of a step of two members
constexpr double least_band = 4;    // of the margin
constexpr int corrections = 4;      // of second order, for one step
constexpr double shrink = 0.4, grow = 2;
constexpr double good = 0.7, poor = 0.2;  // actual decrease over predicted one: grow, shrink
constexpr double most_trust = 0.5;        // of the radius
constexpr double stationary = 1e-11;      // predicted decrease of the length, relative: distances to 1e-5 or better
constexpr double least_trust = 1e-9;      // of the radius
constexpr std::array<double, 2> outward{0.02, 0.08};  // shares of the trust region for a pose that collides

Pose stepped(const Pose& from, const SmallMotion& motion) {
  Pose pose = from;
  for (std::size_t k = 0; k < pose.motions.size(); ++k)
    if (!motion.tau[k].isZero(0) || !motion.omega[k].isZero(0))
      pose.motions[k] = compose(from.motions[k], {rotation_of(motion.omega[k]), motion.tau[k]});
  return pose;
}

}  // namespace

void AssemblyWalker::find_conditions(const Pose& pose, double band, double margin) {
  conditions_.clear();
  const Assembly& assembly = standing_.assembly();
  for (std::size_t i = 0; i < assembly.pairs.size(); ++i) {
    const MemberPair& pair = assembly.pairs[i];
    if (!standing_.member(pair.a).moves() && !standing_.member(pair.b).moves()) continue;
    if (!standing_.near(pose, pair, band)) continue;
    near_.find(standing_.encounter(pose, pair), {}, band, margin);
    const Placement a = standing_.placement(pose, pair.a);
    const Vec3 of_surface = a(standing_.surface(pair.a, pair.a_surface).shape.centroid);
    const Vec3 centre_a = standing_.member(pair.a).centroid + pose.motions[pair.a].shift,
               centre_b = standing_.member(pair.b).centroid + pose.motions[pair.b].shift;
    for (const NearCondition& near : near_.conditions) {
      AssemblyCondition& condition = conditions_.emplace_back();
      condition.pair = i;
      condition.normal = a.rotation * near.normal;
      const Vec3 on_a = of_surface + a.rotation * near.arm;
      condition.arm_a = on_a - centre_a;
      condition.arm_b = on_a - near.distance * condition.normal - centre_b;
      condition.distance = near.distance;
      condition.bound = near.bound;
      condition.triangle_a = near.a;
      condition.triangle_b = near.b;
    }
  }
}

bool AssemblyWalker::correct_bounds(const Pose& trial, const SmallMotion& motion, double margin) {
  bool grew = false;
  for (AssemblyCondition& condition : conditions_) {
    const MemberPair& pair = standing_.assembly().pairs[condition.pair];
    const auto triangle = [&](std::size_t k, std::size_t s, LocalIndex t) {
      const Placement placement = standing_.placement(trial, k);
      geometry::Triangle corners = nth(standing_.surface(k, s).tree.triangles, t);
      for (Vec3& corner : corners) corner = placement(corner);
      return corners;
    };
    const double gap = gap_of(triangle(pair.a, pair.a_surface, condition.triangle_a),
                              triangle(pair.b, pair.b_surface, condition.triangle_b), condition.normal);
    if (!(gap < margin) || !std::isfinite(gap)) continue;
    const double bound = approach(standing_, condition, motion) + (margin - gap);
    if (!(bound > condition.bound)) continue;
    condition.bound = bound;
    grew = true;
  }
  return grew;
}

std::optional<Pose> AssemblyWalker::attempt(AssemblyStep& step, const Pose& from, SmallMotion motion, double trust,
                                            double margin, double below) {
  Pose trial = stepped(from, motion);
  for (int i = 0;; ++i) {
    if (!(standing_.length(trial) < below)) return std::nullopt;
    if (standing_.free(trial)) return trial;
    if (i == corrections || !correct_bounds(trial, motion, margin)) break;
    double predicted = 0;
    std::optional<SmallMotion> corrected = step.solve(conditions_, trust, predicted);
    if (!corrected) break;
    motion = std::move(*corrected);
    trial = stepped(from, motion);
  }
  const double length = standing_.length(trial);
  for (const double push : outward) {
    Pose out = along_screws(trial, 1 + push * trust / length);
    if (!(standing_.length(out) < below)) break;
    if (standing_.free(out)) return out;
  }
  return std::nullopt;
}

Pose AssemblyWalker::walk(const Pose& start, const AssemblyWalkOptions& options) {
  Pose pose = start;
  double length = standing_.length(pose), trust = options.trust, share = band_share;
  for (int i = 0; i < options.most_steps && trust > least_trust * standing_.radius(); ++i, ++steps_) {
    const double band = std::max(share * trust, least_band * options.margin);
    find_conditions(pose, band, options.margin);
    AssemblyStep step(standing_, pose);
    double predicted = 0;
    const std::optional<SmallMotion> motion = step.solve(conditions_, trust, predicted);
    if (motion && length - predicted <= stationary * length) break;
    const std::optional<Pose> trial =
        motion ? attempt(step, pose, *motion, trust, options.margin, length) : std::nullopt;
    if (!trial) {
      if (band < wide_band * trust)
        share *= widen;
      else
        trust = shrink * (motion ? std::min(trust, motion->size) : trust);
      continue;
    }
    const double now = standing_.length(*trial), gain = (length - now) / (length - predicted);
    if (gain > good) trust = std::min(grow * trust, most_trust * standing_.radius());
    if (gain < poor) trust *= shrink;
    pose = *trial;
    length = now;
    share = band_share;
  }
  return pose;
}

}  // namespace brunt::depth
