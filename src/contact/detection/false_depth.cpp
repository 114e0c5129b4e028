// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/detection/false_depth.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "brunt/contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

using geometry::Region;

/// From the node to the nearest point of the face.
double distance_to_face(const Encounter& e) {
  return std::sqrt(e.height * e.height + e.beside * e.beside);
}

/// Of the face around the encounter's point [rad]; all of it, or half of it, but at a corner.
double angle_at_point(const FacesInMotion& scene, const Encounter& e) {
  constexpr double straight = 3.14159265358979323846;
  if (e.region == Region::face) return 2 * straight;
  if (e.region < Region::vertex0) return straight;
  const MasterFace& face = scene.faces[static_cast<std::size_t>(e.face)];
  const auto count = static_cast<std::size_t>(face.corner_count);
  const auto corner = static_cast<std::size_t>(static_cast<int>(e.region) - static_cast<int>(Region::vertex0));
  const auto at = [&](std::size_t i) -> const Vec3& {
    return scene.motion[static_cast<std::size_t>(face.nodes[i % count])].position;
  };
  const Vec3 next = at(corner + 1) - at(corner), last = at(corner + count - 1) - at(corner);
  return std::atan2(next.cross(last).norm(), next.dot(last));
}

/// Of the surface near the node.
struct Nearest {
  const Encounter* face = nullptr;
  double distance = 0;
  double opposition = 0;  ///< the largest one of the faces that share the point
  bool outside = false;
};

Nearest nearest_of(const FacesInMotion& scene, const Tolerances& tolerances, std::span<const Encounter> encounters) {
  Nearest nearest;
  for (const Encounter& e : encounters)
    if (!std::isnan(e.height) && (nearest.face == nullptr || distance_to_face(e) < nearest.distance))
      nearest = {.face = &e, .distance = distance_to_face(e)};
  if (nearest.face == nullptr) return nearest;
  nearest.opposition = nearest.face->opposition;
  double height = 0;
  for (const Encounter& e : encounters) {
    if (std::isnan(e.height) || (e.point - nearest.face->point).norm() > tolerances.fine_rounding * e.size) continue;
    height += angle_at_point(scene, e) * e.height;
    nearest.opposition = std::max(nearest.opposition, e.opposition);
  }
  nearest.outside = height > 0;
  return nearest;
}

/// Would the surface lie far behind the face there, as it does around a convex edge?
bool lies_behind(const Vec3& point, const Encounter& face, const Tolerances& tolerances) {
  return (point - face.point).dot(face.normal) < tolerances.competing * face.height;
}

}  // namespace

void reject_false_depths(const FacesInMotion& scene, const Tolerances& tolerances, std::span<Encounter> encounters) {
  const auto is_deep = [&](const Encounter& e, double than) {
    return e.meeting == Meeting::inside && !scene.faces[static_cast<std::size_t>(e.face)].two_sided &&
           -e.height > than + tolerances.rim * e.size;
  };
  if (std::ranges::none_of(encounters, [&](const Encounter& e) { return is_deep(e, 0); })) return;
  const Nearest nearest = nearest_of(scene, tolerances, encounters);
  if (nearest.face == nullptr) return;
  double most = 0;
  for (const Encounter& e : encounters)
    if (!std::isnan(e.height)) most = std::max(most, e.opposition);
  const bool opposed = nearest.opposition >= tolerances.slight * most;
  const bool clear = nearest.outside && nearest.distance > tolerances.touching * nearest.face->size;
  if (!opposed && !clear) return;
  const Vec3 point = nearest.face->point;
  const double reached = nearest.outside ? 0 : nearest.distance;
  for (Encounter& e : encounters)
    if (is_deep(e, reached) && lies_behind(point, e, tolerances)) e.meeting = Meeting::none;
}

}  // namespace brunt::contact
