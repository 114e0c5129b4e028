// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/ledges.hpp"

#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

/// Relative displacement of node and contact point in the last step. The velocities after contact are used: the
/// predicted ones include the load that presses the node into a face which supports it.
Vec3 last_displacement(const FacesInMotion& scene, const NodeMotion& slave, const Encounter& e) {
  return scene.dt * relative_velocity<&NodeMotion::old_velocity>(scene, slave, scene.face(e), e.weights);
}

/// Whether the contact point on the lateral face is below the common edge with `top` by no more than a ledge.
bool meets_ledge(const FacesInMotion& scene, const Encounter& lateral, const Encounter& top) {
  const Tolerances& tolerances = scene.tolerances;
  const double height = tolerances.ledge * std::min(lateral.size, top.size);
  if (!(top.height <= 0) || -top.height > height || top.opposition < tolerances.competing * lateral.opposition)
    return false;
  if (same_direction(lateral.normal, top.normal, tolerances.same_direction)) return false;  // the usual case
  return (top.point - lateral.point).dot(top.normal) <= 2 * height &&
         shared_nodes(scene.face(lateral), scene.face(top)) >= 2 && !concave(scene, lateral, top);
}

}  // namespace

void remove_lateral_faces_of_ledges(const FacesInMotion& scene, const NodeMotion& slave,
                                    std::span<Encounter> encounters) {
  if (one_direction(encounters, scene.tolerances.same_direction)) return;  // the usual case
  for (Encounter& lateral : encounters) {
    if (lateral.meeting == Meeting::none) continue;
    const auto is_top_of_ledge = [&](const Encounter& top) {
      return &top != &lateral && meets_ledge(scene, lateral, top) &&
             slides_into(last_displacement(scene, slave, lateral), lateral.normal, top.normal, lateral.size,
                         scene.tolerances);
    };
    if (std::ranges::any_of(encounters, is_top_of_ledge)) lateral.meeting = Meeting::none;
  }
}

}  // namespace brunt::contact
