// SPDX-License-Identifier: Apache-2.0
#include "assembly_start.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "depth/penetration_depth.hpp"
#include "plane_program.hpp"

namespace brunt::depth {
namespace {

constexpr int most_rounds = 60;       // of planes, and of pairs
constexpr int most_turned_aside = 3;  // directions of one pair
constexpr double beyond = 1e-3;       // of a translation: initial clearance of walks
constexpr double push_growth = 0.02;  // in each round of pairs, so that members in a dense group do not overlap again
constexpr double first_spread = 0.02, spread_growth = 1.3;
constexpr int most_spreads = 40;  // the last is 1.3^40 x 0.02 = 700 distances from the centre

/// Orthonormal columns that span both bases, without `aside`; unused columns are zero.
Mat3 common_basis(const Member& a, const Member& b, const std::vector<Vec3>& aside) {
  Mat3 done = Mat3::Zero();
  std::vector<Vec3> kept;
  std::vector<Vec3> known;
  for (const Vec3& u : aside) {
    Vec3 v = u;
    for (const Vec3& other : known) v -= other.dot(v) * other;
    if (v.norm() > 1e-6) known.push_back(v.normalized());
  }
  for (const Mat3* basis : {&a.basis, &b.basis})
    for (int c = 0; c < 3; ++c) {
      Vec3 v = basis->col(c);
      for (const Vec3& other : known) v -= other.dot(v) * other;
      if (known.size() >= 3 || !(v.norm() > 1e-6)) continue;
      v.normalize();
      known.push_back(v);
      kept.push_back(v);
    }
  for (std::size_t k = 0; k < kept.size(); ++k) done.col(static_cast<int>(k)) = kept[k];
  return done;
}

/// The shortest translation of a out of b, in the common axes; none if the basis admits none.
std::optional<Vec3> separating(const Standing& standing, const Pose& pose, const MemberPair& pair, const Mat3& basis) {
  if (basis.isZero(0)) return std::nullopt;
  const Encounter here = standing.encounter(pose, pair);
  const Mat3 to_common = standing.placement(pose, pair.b).rotation;
  Query query;
  query.a_in_b = here.start;
  query.metric = Metric::translation;
  query.touching = true;
  if (!(basis.colwise().norm().array() > 0).all())
    for (int c = 0; c < 3; ++c)
      if (!basis.col(c).isZero(0)) query.along.emplace_back(to_common.transpose() * basis.col(c));
  const Answer answer = penetration_depth(here.a, here.b, query);
  if (!answer.overlap) return Vec3(Vec3::Zero());
  if (!answer.found) return std::nullopt;
  return Vec3(to_common * (here.start.rotation * answer.motion.shift));
}

/// Splits a relative translation so that sum m |x|^2 is least.
void share_translation(const Standing& standing, const MemberPair& pair, const Vec3& t, Pose& pose) {
  const Member &a = standing.member(pair.a), &b = standing.member(pair.b);
  const Mat3 of_a = a.basis * a.basis.transpose() / a.mass, of_b = b.basis * b.basis.transpose() / b.mass;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(of_a + of_b);
  Vec3 force = Vec3::Zero();  // zero along directions in which neither member moves
  for (int c = 0; c < 3; ++c)
    if (const Vec3 axis = solver.eigenvectors().col(c); solver.eigenvalues()[c] > 1e-9 * solver.eigenvalues()[2])
      force += axis.dot(t) / solver.eigenvalues()[c] * axis;
  pose.motions[pair.a].shift += of_a * force;
  pose.motions[pair.b].shift -= of_b * force;
}

/// The screw from one placement of a surface to another, at the fraction s, as a motion of its member.
void move_along(const Standing& standing, std::size_t k, const Vec3& centroid, const Placement& to, double s,
                Pose& pose) {
  const Placement from = standing.placement(pose, k);
  const Placement part = moved(from, along_screw(motion_between(from, to, centroid), s), centroid);
  pose.motions[k] = motion_between({}, part, standing.member(k).centroid);
}

bool is_full(const Member& member) {
  return member.turns && (member.basis.colwise().norm().array() > 0).all();
}

/// Separates the pair by its least motion; false if this is impossible.
bool part_pair(const Standing& standing, const MemberPair& pair, double push, double margin, Pose& pose) {
  const Member &a = standing.member(pair.a), &b = standing.member(pair.b);
  const bool screws = (is_full(a) || !a.moves()) && (is_full(b) || !b.moves());
  if (!screws) {
    const std::optional<Vec3> t = separating(standing, pose, pair, common_basis(a, b, {}));
    if (t && !t->isZero(0)) share_translation(standing, pair, (push + margin / t->norm()) * *t, pose);
    return t.has_value();
  }
  const Encounter here = standing.encounter(pose, pair);
  Query query;
  query.a_in_b = here.start;
  query.metric = Metric::object_norm;
  query.touching = true;
  const Answer answer = penetration_depth(here.a, here.b, query);
  if (!answer.overlap) return true;
  if (!answer.found) return false;
  const double out = push + margin / answer.depth;
  const double share = !a.moves() ? 0 : !b.moves() ? 1 : b.mass / (a.mass + b.mass);
  const Placement from_a = standing.placement(pose, pair.a), from_b = standing.placement(pose, pair.b);
  // M moves a to its position beside b, its inverse moves b to the position from which a has that relative position
  const Placement to_a{from_b.rotation * answer.placement.rotation,
                       from_b.rotation * answer.placement.translation + from_b.translation};
  const Mat3 R = from_a.rotation * to_a.rotation.transpose();  // of the inverse of M
  const Placement to_b{R * from_b.rotation, R * (from_b.translation - to_a.translation) + from_a.translation};
  if (share > 0) move_along(standing, pair.a, here.a.shape.centroid, to_a, share * out, pose);
  if (share < 1) move_along(standing, pair.b, here.b.shape.centroid, to_b, (1 - share) * out, pose);
  return true;
}

}  // namespace

std::optional<Pose> start_by_planes(const Standing& standing, double margin, std::vector<std::size_t>& stuck) {
  const Assembly& assembly = standing.assembly();
  const PlaneProgram program(standing);
  std::vector<Plane> planes;
  std::vector<std::vector<Vec3>> aside(assembly.pairs.size());
  Pose pose = standing.start();
  for (int round = 0; round < most_rounds; ++round) {
    stuck = standing.overlapping(pose);
    if (stuck.empty()) return pose;
    for (const std::size_t i : stuck) {
      const MemberPair& pair = assembly.pairs[i];
      const Mat3 basis = common_basis(standing.member(pair.a), standing.member(pair.b), aside[i]);
      const std::optional<Vec3> t = separating(standing, pose, pair, basis);
      if (!t) {
        stuck = {i};
        return std::nullopt;
      }
      const Vec3 u = t->isZero(0) ? Vec3(basis.col(0)) : Vec3(t->normalized());
      const Vec3 x = pose.motions[pair.a].shift - pose.motions[pair.b].shift;
      planes.push_back({i, u, u.dot(x) + (1 + beyond) * t->norm() + margin});
    }
    std::vector<std::size_t> proof;
    while (!program.solve(planes, pose, proof)) {
      // the last plane between two movable members is removed, otherwise the last one
      std::size_t yields = planes.size();
      for (const std::size_t p : proof) {
        const MemberPair& pair = assembly.pairs[planes[p].pair];
        if (aside[planes[p].pair].size() >= most_turned_aside) continue;
        const auto free_ends = [&](const MemberPair& ends) {
          return (standing.member(ends.a).moves() ? 1 : 0) + (standing.member(ends.b).moves() ? 1 : 0);
        };
        if (yields == planes.size() || free_ends(pair) > free_ends(assembly.pairs[planes[yields].pair]) ||
            (free_ends(pair) == free_ends(assembly.pairs[planes[yields].pair]) && p > yields))
          yields = p;
      }
      if (yields == planes.size()) {
        for (const std::size_t p : proof) stuck.push_back(planes[p].pair);
        std::sort(stuck.begin(), stuck.end());
        stuck.erase(std::unique(stuck.begin(), stuck.end()), stuck.end());
        return std::nullopt;
      }
      const std::size_t pair = planes[yields].pair;
      aside[pair].push_back(planes[yields].along);
      std::erase_if(planes, [&](const Plane& plane) { return plane.pair == pair; });
    }
  }
  return std::nullopt;
}

std::optional<Pose> start_by_pairs(const Standing& standing, double margin) {
  Pose pose = standing.start();
  for (int round = 0; round < most_rounds; ++round) {
    bool free = true;
    for (const MemberPair& pair : standing.assembly().pairs) {
      if (!standing.collides(pose, pair)) continue;
      free = false;
      if (!part_pair(standing, pair, 1 + beyond + push_growth * round, margin, pose)) return std::nullopt;
    }
    if (free) return pose;
  }
  return std::nullopt;
}

std::optional<Pose> start_by_expansion(const Standing& standing) {
  Vec3 centre = Vec3::Zero();
  double mass = 0;
  for (const Member& member : standing.assembly().members) {
    if (!member.moves()) continue;
    centre += member.mass * member.centroid;
    mass += member.mass;
  }
  centre /= mass;
  double spread = first_spread;
  for (int i = 0; i < most_spreads; ++i, spread *= spread_growth) {
    Pose pose = standing.start();
    for (std::size_t k = 0; k < pose.motions.size(); ++k) {
      const Member& member = standing.member(k);
      Vec3 away = member.centroid - centre;
      if (away.norm() < 1e-3 * standing.radius())  // a member at the centre, and coincident ones, need a direction too
        away = standing.radius() *
               Vec3(std::cos(static_cast<double>(k)), std::sin(static_cast<double>(k)), 0.3 * static_cast<double>(k));
      pose.motions[k].shift = spread * (member.basis * (member.basis.transpose() * away));
    }
    if (standing.free(pose)) return pose;
  }
  return std::nullopt;
}

}  // namespace brunt::depth
