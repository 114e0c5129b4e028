// SPDX-License-Identifier: Apache-2.0
#include "assembly_pose.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::depth {

Standing::Standing(const Assembly& assembly) : assembly_(assembly) {
  for (const Member& member : assembly.members) {
    if (!member.moves()) continue;
    mass_ += member.mass;
    for (const Body* body : member.surfaces) radius_ = std::max(radius_, body->shape.radius);
  }
}

Pose Standing::start() const {
  return {std::vector<RigidMotion>(assembly_.members.size())};
}

Placement Standing::relative(const Pose& pose, const MemberPair& pair) const {
  const Placement a = placement(pose, pair.a), b = placement(pose, pair.b);
  return {b.rotation.transpose() * a.rotation, b.rotation.transpose() * (a.translation - b.translation)};
}

bool Standing::near(const Pose& pose, const MemberPair& pair, double reach) const {
  const MetricShape &a = surface(pair.a, pair.a_surface).shape, &b = surface(pair.b, pair.b_surface).shape;
  const Vec3 between = placement(pose, pair.a)(a.centroid) - placement(pose, pair.b)(b.centroid);
  return between.norm() < (1 + 1e-9) * (a.radius + b.radius) + reach;  // margin above rounding
}

bool Standing::collides(const Pose& pose, const MemberPair& pair) const {
  if (!near(pose, pair, 0)) return false;
  const Encounter here = encounter(pose, pair);
  return here.bodies_collide(here.start);
}

bool Standing::free(const Pose& pose) const {
  return std::none_of(assembly_.pairs.begin(), assembly_.pairs.end(),
                      [&](const MemberPair& pair) { return collides(pose, pair); });
}

std::vector<std::size_t> Standing::overlapping(const Pose& pose) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < assembly_.pairs.size(); ++i)
    if (collides(pose, assembly_.pairs[i])) found.push_back(i);
  return found;
}

double Standing::length(const Pose& pose) const {
  double sum = 0;
  for (std::size_t k = 0; k < assembly_.members.size(); ++k) {
    const Vec3 v = pose.motions[k].turn.vec();
    sum += member(k).mass * (pose.motions[k].shift.squaredNorm() + 4 * v.dot(member(k).gyration * v));
  }
  return mass_ > 0 ? std::sqrt(sum / mass_) : 0;
}

double Standing::farthest(const Pose& pose, std::size_t k) const {
  const RigidMotion& motion = pose.motions[k];
  const Mat3 D = rotation_less_identity(motion.turn);
  double most = 0;
  for (const Body* body : member(k).surfaces) {
    const Vec3 T = motion.shift + D * (body->shape.centroid - member(k).centroid);
    most = std::max(most, depth::farthest(body->shape, D, T).distance);
  }
  return most;
}

Pose along_screws(const Pose& pose, double s) {
  Pose result;
  result.motions.reserve(pose.motions.size());
  for (const RigidMotion& motion : pose.motions) result.motions.push_back(along_screw(motion, s));
  return result;
}

}  // namespace brunt::depth
