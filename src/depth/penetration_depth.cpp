// SPDX-License-Identifier: Apache-2.0
#include "depth/penetration_depth.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "depth/lower_bound.hpp"
#include "joint_search.hpp"

namespace brunt::depth {
namespace {

constexpr double contact_band = 1e-4;  // of A's radius: gaps of contact points
constexpr double clear_gap = 1e-9;     // of A's radius: the nearest points of larger gaps give a direction to 7 digits
constexpr double trusted = 1.2;        // of the lower bound: a longer answer of a warm start is searched again
constexpr double touch = 1e-12;        // of A's radius: smaller overlaps of surfaces are rounding
constexpr double two_sides = 2;        // of the bound: the most that overlaps add up to, one on each side
constexpr double explained = 1.01;     // of the overlaps
constexpr double independent = 1e-6;   // sine: directions nearer to the span of the others are dependent

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
    if (have < 3 && v.norm() > independent) basis.col(have++) = v.normalized();
  }
  return basis;
}

/// From B to A: between the nearest points, or from the touching features if those are too near for a direction.
Vec3 contact_normal(const Encounter& encounter, const Placement& placement, const NearCondition& condition) {
  const Vec3 normal = (encounter.start.rotation * condition.normal).normalized();
  if (condition.distance > clear_gap * encounter.a.shape.radius) return normal;
  geometry::Triangle a = nth(encounter.a.tree.triangles, condition.a);
  for (Vec3& corner : a) corner = placement(corner);
  const Vec3 axis = separating_axis(a, nth(encounter.b.tree.triangles, condition.b));
  return axis.squaredNorm() > 0 ? axis : normal;
}

void list_contacts(const Encounter& encounter, Answer& answer) {
  NearPairs near;
  near.find(encounter, answer.motion, encounter.apart + contact_band * encounter.a.shape.radius, 0);
  const Mat3& out = encounter.start.rotation;
  const Vec3 centre = answer.placement(encounter.a.shape.centroid);
  for (const NearCondition& condition : near.conditions) {
    const Vec3 normal = contact_normal(encounter, answer.placement, condition);
    answer.contacts.push_back(
        {centre + out * condition.arm - 0.5 * condition.distance * normal, normal, condition.distance});
  }
}

/// Covers all motions shorter than the answer; free placements found in this search improve it.
void certify(const Encounter& encounter, const Query& query, Search& search, Answer& answer) {
  const CoverOptions options{query.metric, query.gap, query.boxes, answer.bound, query.evaluate, query.stop};
  const auto improve = [&](const RigidMotion& motion) {
    search.walk_from(motion);
    search.finish(query.careful);
    return search.best().length;
  };
  const CoverResult result = cover(encounter, search.best().length, options, improve);
  answer.bound = std::min(std::max(answer.bound, result.bound), search.best().length);
  answer.certified = result.reached;
  answer.boxes = result.boxes;
}

/// Of PDt, DISP and rms.
std::array<double, 3> bounds_of(const Encounter& encounter, const Query& query) {
  const BoundEffort& effort = query.careful ? thorough_bound : quick_bound;
  std::array<double, 3> bounds{};
  bounds[0] = bounds[1] = lower_bound(encounter, Metric::displacement, effort).value;
  if (query.careful || query.metric == Metric::object_norm)
    bounds[2] = lower_bound(encounter, Metric::object_norm, effort).value;
  return bounds;
}

/// Starts, walks, certificate.
void search_all(Encounter& encounter, const Query& query, const Mat3& basis, Answer& answer) {
  const std::array<double, 3> bounds = bounds_of(encounter, query);
  answer.bound = nth(bounds, query.metric);
  JointSearch joint(encounter, query, basis, bounds);
  const double sum = joint.small_motions().sum_of_overlaps(), deepest = bounds[0] - encounter.apart;
  if (!query.touching && std::max(sum, deepest) <= touch * encounter.a.shape.radius) {
    answer = Answer{};
    answer.placement = encounter.start;
    return;
  }
  answer.overlaps = encounter.apart + (deepest > 0 ? std::clamp(sum, deepest, two_sides * deepest) : sum);
  joint.try_placements();
  if (query.careful && !query.warm) {  // with its own bounds, on which its starts depend
    Query quick = query;
    quick.careful = false;
    JointSearch fast(encounter, quick, basis, bounds_of(encounter, quick));
    fast.try_placements();
    fast.run();
    joint.take(fast);
  }
  const bool trust = query.warm && joint.asked().best().length <= trusted * answer.bound;
  if (trust)
    joint.asked().finish(query.careful);
  else
    joint.run();
  Search& search = joint.asked();
  answer.found = search.found();
  if (answer.found) {
    if (query.boxes > 0 && query.along.empty()) certify(encounter, query, search, answer);
    answer.motion = search.best().motion;
    answer.depth = search.best().length;
    answer.placement = encounter.placement(answer.motion);
    answer.bound = std::min(answer.bound, answer.depth);
    list_contacts(encounter, answer);
  }
  answer.walks = joint.walks();
  answer.steps = joint.steps();
  answer.pairs = joint.pairs();
}

}  // namespace

bool far_above_overlaps(const Answer& answer) {
  return answer.overlap && answer.found && answer.depth > explained * answer.overlaps;
}

Answer penetration_depth(const Body& a, const Body& b, const Query& query) {
  Answer answer;
  Encounter encounter{a, b, rounded(query.a_in_b, a.shape.radius)};
  answer.placement = encounter.start;
  answer.overlap = encounter.collides({});
  if (answer.overlap) {
    encounter.apart = query.apart;
    const Mat3 basis = admitted(query, encounter.start.rotation.transpose());
    search_all(encounter, query, basis, answer);
  } else {
    answer.distance = geometry::surface_distance(a.tree, b.tree, encounter.start);
  }
  answer.proven = !a.crosses_itself && !b.crosses_itself;
  answer.queries = encounter.queries;
  return answer;
}

}  // namespace brunt::depth
