// SPDX-License-Identifier: Apache-2.0
#include "brunt/depth/penetration_depth.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "brunt/depth/lower_bound.hpp"
#include "brunt/depth/starts.hpp"
#include "brunt/depth/walk.hpp"

namespace brunt::depth {
namespace {

constexpr double close_to_bound = 1 + 1e-7;  // an answer this near to the bound needs no more walks
constexpr double near_start = 0.1;           // of the length: starts nearer to each other share their walk
constexpr double contact_band = 1e-4;        // of A's radius: gaps of contact points

struct Effort {
  std::size_t walks;
  int grid;
  double pull;  // accuracy of the final contact, in units of A's radius
  WalkOptions walk;
};

Effort effort_of(const Query& query, const Mat3& basis) {
  Effort effort{2, 1, 1e-7, {}};
  effort.walk.metric = query.metric;
  effort.walk.clearance = query.clearance;
  effort.walk.basis = basis;
  if (query.careful) {
    effort.walks = 25;
    effort.grid = 3;
    effort.pull = 1e-9;
    effort.walk.slope = 1e-3;
    effort.walk.most_steps = 100;
  }
  return effort;
}

/// Orthonormal columns that span the directions, in A's axes at q_0.
Mat3 admitted(const Query& query, const Mat3& into) {
  if (query.along.empty()) return Mat3::Identity();
  if (query.metric != Metric::translation)
    throw std::invalid_argument("directions are for the metric translation only");
  Mat3 basis = Mat3::Zero();
  int have = 0;
  for (const Vec3& direction : query.along) {
    Vec3 v = into * direction.normalized();
    for (int k = 0; k < have; ++k) v -= basis.col(k).dot(v) * basis.col(k);
    if (have < 3 && v.norm() > 1e-6) basis.col(have++) = v.normalized();
  }
  return basis;
}

RigidMotion difference(const RigidMotion& one, const RigidMotion& other) {
  return {(other.turn * one.turn.conjugate()).normalized(), other.shift - one.shift};
}

class Search {
 public:
  Search(Encounter& encounter, const Effort& effort, Answer& answer)
      : encounter_(encounter), effort_(effort), answer_(answer) {}

  void walk_from(const RigidMotion& start) {
    const WalkResult result = walker_.walk(encounter_, start, effort_.walk);
    ++answer_.walks;
    answer_.steps += result.steps;
    if (result.length < best_.length) best_ = {result.motion, result.length};
  }

  [[nodiscard]] bool done() const { return best_.length <= close_to_bound * answer_.bound; }
  [[nodiscard]] const Start& best() const { return best_; }

  void walk_from_all(const std::vector<Start>& starts) {
    std::vector<RigidMotion> used;
    for (const Start& start : starts) {
      if (used.size() >= effort_.walks || done()) break;
      const bool known = std::any_of(used.begin(), used.end(), [&](const RigidMotion& other) {
        return length_of(encounter_.a.shape, effort_.walk.metric, difference(start.motion, other)) <
               near_start * start.length;
      });
      if (known) continue;
      used.push_back(start.motion);
      walk_from(start.motion);
    }
  }

  /// The best answer brought to contact, and in the careful mode improved from there with a thousandth of the
  /// clearance.
  void finish(bool careful) {
    const double radius = encounter_.a.shape.radius;
    const Metric metric = effort_.walk.metric;
    best_.motion = pulled(encounter_, metric, best_.motion, effort_.pull * radius);
    if (careful) {
      WalkOptions fine = effort_.walk;
      fine.clearance *= 1e-2;
      fine.slope = 1e-7;
      fine.least_trust = 1e-8;
      fine.most_steps = 200;
      const Start start = freed(encounter_, metric, along_screw(best_.motion, 1 + 1e-7));
      if (start.length > 0) {
        const WalkResult result = walker_.walk(encounter_, start.motion, fine);
        answer_.steps += result.steps;
        const RigidMotion motion = pulled(encounter_, metric, result.motion, effort_.pull * radius);
        if (length_of(encounter_.a.shape, metric, motion) < length_of(encounter_.a.shape, metric, best_.motion))
          best_.motion = motion;
      }
    }
    best_.length = length_of(encounter_.a.shape, metric, best_.motion);
  }

 private:
  Encounter& encounter_;
  const Effort& effort_;
  Answer& answer_;
  Walker walker_;
  Start best_{{}, std::numeric_limits<double>::infinity()};
};

void list_contacts(const Encounter& encounter, Answer& answer) {
  NearPairs near;
  near.find(encounter, answer.motion, contact_band * encounter.a.shape.radius, 0);
  const Mat3& out = encounter.start.rotation;
  const Vec3 centre = answer.placement(encounter.a.shape.centroid);
  for (const NearCondition& condition : near.conditions) {
    const Vec3 normal = out * condition.normal;
    answer.contacts.push_back(
        {centre + out * condition.arm - 0.5 * condition.distance * normal, normal, condition.distance});
  }
}

}  // namespace

Answer penetration_depth(const Body& a, const Body& b, const Query& query) {
  Answer answer;
  Encounter encounter{a, b, rounded(query.a_in_b, a.shape.radius)};
  answer.placement = encounter.start;
  answer.overlap = encounter.collides({});
  if (!answer.overlap) {
    answer.distance = geometry::surface_distance(a.tree, b.tree, encounter.start);
    answer.queries = encounter.queries;
    return answer;
  }
  const Mat3 basis = admitted(query, encounter.start.rotation.transpose());
  const Effort effort = effort_of(query, basis);
  answer.bound = lower_bound(encounter, query.metric).value;

  Search search(encounter, effort, answer);
  for (const Placement& placement : query.tries) {
    const RigidMotion motion = motion_between(encounter.start, placement, a.shape.centroid);
    const Start start = freed(encounter, query.metric, motion);
    if (start.length > 0) search.walk_from(start.motion);
  }
  if (query.careful || query.tries.empty()) {
    StartOptions options;
    options.metric = query.metric;
    options.grid = effort.grid;
    options.basis = basis;
    options.nothing_below = answer.bound;
    search.walk_from_all(find_starts(encounter, options));
  }
  answer.found = std::isfinite(search.best().length);
  if (answer.found) {
    search.finish(query.careful);
    answer.motion = search.best().motion;
    answer.depth = search.best().length;
    answer.placement = encounter.placement(answer.motion);
    list_contacts(encounter, answer);
  }
  answer.queries = encounter.queries;
  return answer;
}

}  // namespace brunt::depth
