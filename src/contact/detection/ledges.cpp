// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/ledges.hpp"

#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

const MasterFace& face_of(const FacesInMotion& scene, const Encounter& e) {
  return scene.faces[static_cast<std::size_t>(e.face)];
}

/// How far node and face point have moved apart in the last step: the predicted velocities hold what presses the node
/// into a face that bears it.
Vec3 last_displacement(const FacesInMotion& scene, const NodeMotion& slave, const Encounter& e) {
  const MasterFace& face = face_of(scene, e);
  Vec3 relative = slave.old_velocity;
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
    relative -= e.weights[i] * scene.motion[static_cast<std::size_t>(face.nodes[i])].old_velocity;
  return scene.dt * relative;
}

/// Is the place where the node meets `side` below the edge of `top` by no more than a ledge?
bool meets_ledge_side(const FacesInMotion& scene, const Tolerances& tolerances, const Encounter& side,
                      const Encounter& top) {
  const double height = tolerances.ledge * std::min(side.size, top.size);
  if (!(top.height <= 0) || -top.height > height || top.opposition < tolerances.competing * side.opposition)
    return false;
  if (contact::same_direction(side.normal, top.normal, tolerances.same_direction)) return false;  // as nearly all are
  return (top.point - side.point).dot(top.normal) <= 2 * height &&
         shared_nodes(face_of(scene, side), face_of(scene, top)) >= 2 &&
         !concave(scene.faces, scene.motion, side, top, tolerances);
}

}  // namespace

void remove_ledge_sides(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave,
                        std::span<Encounter> encounters) {
  if (one_direction(encounters, tolerances.same_direction)) return;  // nearly always
  for (Encounter& side : encounters) {
    if (side.meeting == Meeting::none) continue;
    const auto is_below = [&](const Encounter& top) {
      return &top != &side && meets_ledge_side(scene, tolerances, side, top) &&
             slides_into(last_displacement(scene, slave, side), side.normal, top.normal, side.size, tolerances);
    };
    if (std::ranges::any_of(encounters, is_below)) side.meeting = Meeting::none;
  }
}

}  // namespace brunt::contact
