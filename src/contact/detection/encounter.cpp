// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/encounter.hpp"

#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"
#include "geometry/first_contact.hpp"
#include "standing.hpp"

namespace brunt::contact {
namespace {

using geometry::Region;

/// A path that crosses a neighbour at this face's rim hits this face as well, if the node approaches it: at a convex
/// corner, rounding decides which of the faces the path crosses.
void join_hit(const FacesInMotion& scene, const NodeMotion& slave, std::span<const Encounter> encounters,
              Encounter& met) {
  for (const Encounter& hit : encounters) {
    if (hit.meeting != Meeting::hit || hit.face == met.face) continue;
    if ((hit.point - met.point).norm() > scene.tolerances.rim * std::min(hit.size, met.size)) continue;
    const Vec3 relative = relative_velocity<&NodeMotion::predicted>(scene, slave, scene.face(met), met.weights);
    const double approach = -met.normal.dot(scene.dt * relative);
    if (!(approach > 0)) continue;
    met.meeting = Meeting::hit;
    met.time = hit.time;
    met.gap = hit.time * approach;
    return;
  }
}

/// The corners as the node sees them: counter-clockwise from its side, offset towards it by the clearance.
void seen_from(const Approach& approach, std::span<Vec3> corners) {
  if (approach.side < 0) std::reverse(corners.begin(), corners.end());
  if (approach.clearance == 0) return;
  const Vec3 out = approach.clearance * geometry::area_vector(corners).normalized();
  for (Vec3& corner : corners) corner += out;
}

}  // namespace

std::array<LocalIndex, 2> nodes_of_feature(const MasterFace& face, Region region) {
  const auto number = static_cast<int>(region);
  const auto count = static_cast<std::size_t>(face.corner_count);
  if (region >= Region::vertex0) {
    const LocalIndex node = nth(face.nodes, number - static_cast<int>(Region::vertex0));
    return {node, node};
  }
  const auto edge = static_cast<std::size_t>(number - static_cast<int>(Region::edge0));
  return {face.nodes[edge], face.nodes[(edge + 1) % count]};
}

bool has_node(const MasterFace& face, LocalIndex node) {
  const auto& corner = face.nodes;
  return static_cast<bool>(static_cast<int>(corner[0] == node) | static_cast<int>(corner[1] == node) |
                           static_cast<int>(corner[2] == node) |
                           (static_cast<int>(corner[3] == node) & static_cast<int>(face.corner_count == 4)));
}

bool one_direction(std::span<const Encounter> encounters, double degrees) {
  const double half = 0.5 * degrees * std::numbers::pi / 180, least = 1 - 0.5 * half * half * (1 - half * half / 12);
  return std::ranges::all_of(
      encounters, [&](const Encounter& e) { return e.normal.dot(encounters.front().normal) > least + 1e-14; });
}

std::ptrdiff_t shared_nodes(const MasterFace& one, const MasterFace& other) {
  return std::count_if(one.nodes.begin(), one.nodes.begin() + one.corner_count,
                       [&](LocalIndex node) { return has_node(other, node); });
}

void find_hit(const FacesInMotion& scene, const NodeMotion& slave, Encounter& met) {
  const MasterFace& face = scene.face(met);
  const auto count = static_cast<std::size_t>(face.corner_count);
  std::array<Vec3, 4> start, end;
  for (std::size_t i = 0; i < count; ++i) {
    start[i] = scene.corner(face, i).position;
    end[i] = start[i] + scene.dt * scene.corner(face, i).predicted;
  }
  seen_from(met.approach, {start.data(), count});
  seen_from(met.approach, {end.data(), count});
  const geometry::MovingPoint point{slave.position, slave.position + scene.dt * slave.predicted};
  const geometry::MovingFace moving{{start.data(), count}, {end.data(), count}};
  if (!geometry::may_meet(point, geometry::sweep_of(moving))) return;
  auto hit = geometry::first_contact(point, moving);
  if (!hit) return;
  if (met.approach.side < 0) std::reverse(hit->weights.begin(), hit->weights.begin() + face.corner_count);
  const Vec3 relative = relative_velocity<&NodeMotion::predicted>(scene, slave, face, hit->weights);
  const double approach = -hit->normal.dot(scene.dt * relative);
  if (!(approach > 0)) return;
  met.meeting = Meeting::hit;
  met.time = hit->tau;
  met.gap = hit->tau * approach;
  met.normal = hit->normal;
  met.point = hit->point - met.approach.clearance * hit->normal;
  met.weights = hit->weights;
}

Encounter encounter(const FacesInMotion& scene, const NodeMotion& slave, LocalIndex face_index,
                    const Approach& approach) {
  Encounter met{.face = face_index, .approach = approach, .size = nth(scene.reach, face_index).size};
  const MasterFace& face = scene.face(face_index);
  std::array<Vec3, 4> storage;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) storage[i] = scene.corner(face, i).position;
  const geometry::Corners corners(storage.data(), count);
  const auto closest = geometry::closest_point(slave.position, corners);
  if (!closest) return met;

  met.region = closest->region;
  met.point = closest->point;
  met.weights = closest->weights;
  met.normal = approach.side * geometry::face_normal(corners, closest->xi, closest->eta);
  const Vec3 relative = relative_velocity<&NodeMotion::predicted>(scene, slave, face, met.weights);
  classify(stand(geometry::vec_of(slave.position), geometry::vec_of(met.point), geometry::vec_of(met.normal),
                 geometry::vec_of(relative), scene.dt),
           scene.tolerances, face.element_depth, met);
  return met;
}

bool concave(const FacesInMotion& scene, const Encounter& a, const Encounter& b) {
  const auto centre = [&](const Encounter& e) {
    const MasterFace& face = scene.face(e);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i) sum += scene.corner(face, i).position;
    return Vec3(sum / face.corner_count);
  };
  return (centre(b) - a.point).dot(a.normal) > scene.tolerances.rounding * b.size &&
         (centre(a) - b.point).dot(b.normal) > scene.tolerances.rounding * a.size;
}

void detect_path_hits(const FacesInMotion& scene, const NodeMotion& slave, std::span<Encounter> encounters) {
  const auto is_in_front = [](const Encounter& e) { return e.height > 0 && is_admissible(e); };
  for (Encounter& e : encounters) {
    const bool closest_point_suffices = e.meeting == Meeting::above && e.slow;
    if (is_in_front(e) && !closest_point_suffices) find_hit(scene, slave, e);
  }
  for (Encounter& e : encounters)
    if (e.meeting == Meeting::none && is_in_front(e)) join_hit(scene, slave, encounters, e);
}

}  // namespace brunt::contact
