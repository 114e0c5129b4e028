// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/detection/encounter.hpp"

#include <algorithm>
#include <cmath>

#include "brunt/contact/data/tolerances.hpp"
#include "brunt/geometry/first_contact.hpp"
#include "standing.hpp"

namespace brunt::contact {
namespace {

using geometry::Region;

const NodeMotion& corner_of(const FacesInMotion& scene, const MasterFace& face, std::size_t i) {
  return scene.motion[static_cast<std::size_t>(face.nodes[i])];
}

/// The node's predicted velocity against the face point's.
Vec3 relative_velocity(const FacesInMotion& scene, const NodeMotion& slave, const MasterFace& face,
                       const std::array<double, 4>& weights) {
  Vec3 relative = slave.predicted;
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
    relative -= weights[i] * corner_of(scene, face, i).predicted;
  return relative;
}

/// Corners of the face that the region consists of; the second is the first for a vertex.
std::array<LocalIndex, 2> feature_nodes(const MasterFace& face, Region region) {
  const auto number = static_cast<int>(region);
  const auto count = static_cast<std::size_t>(face.corner_count);
  if (region >= Region::vertex0) {
    const LocalIndex node = face.nodes[static_cast<std::size_t>(number - static_cast<int>(Region::vertex0))];
    return {node, node};
  }
  const auto edge = static_cast<std::size_t>(number - static_cast<int>(Region::edge0));
  return {face.nodes[edge], face.nodes[(edge + 1) % count]};
}

/// Without a branch: which corner it is is different at every turn.
bool has_node(const MasterFace& face, LocalIndex node) {
  const auto& corner = face.nodes;
  return static_cast<bool>(static_cast<int>(corner[0] == node) | static_cast<int>(corner[1] == node) |
                           static_cast<int>(corner[2] == node) |
                           (static_cast<int>(corner[3] == node) & static_cast<int>(face.corner_count == 4)));
}

/// A face whose rim is where the node passes through a neighbour, and that has it in front as well, is hit with it: at
/// a convex corner it is rounding that decides which one the path crosses.
void join_hit(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave,
              std::span<const Encounter> encounters, Encounter& met) {
  for (const Encounter& hit : encounters) {
    if (hit.meeting != Meeting::hit || hit.face == met.face) continue;
    if ((hit.point - met.point).norm() > tolerances.rim * std::min(hit.size, met.size)) continue;
    const double approach = -met.normal.dot(
        scene.dt * relative_velocity(scene, slave, scene.faces[static_cast<std::size_t>(met.face)], met.weights));
    if (!(approach > 0)) continue;
    met.meeting = Meeting::hit;
    met.time = hit.time;
    met.gap = hit.time * approach;
    return;
  }
}

/// May a node that projects beside encounters[i] count as on the face? Every neighbour has its say, in whatever order.
bool holds_at_rim(const FacesInMotion& scene, const Tolerances& tolerances, std::span<const Encounter> encounters,
                  std::size_t i) {
  const Encounter& e = encounters[i];
  const bool near_rim = e.beside <= tolerances.rim * e.size;
  if (!near_rim && e.height > 0) return false;
  const auto [first, second] = feature_nodes(scene.faces[static_cast<std::size_t>(e.face)], e.region);
  bool has_neighbour = false, behind_all = true;
  for (std::size_t k = 0; k < encounters.size(); ++k) {
    const Encounter& other = encounters[k];
    const bool in_front = other.height > 0;
    if (k == i || std::isnan(other.height) || (near_rim && !in_front)) continue;
    const MasterFace& face = scene.faces[static_cast<std::size_t>(other.face)];
    if (!has_node(face, first) || !has_node(face, second)) continue;
    // in one plane it is rounding that says which of the two has the node in front
    const auto behind_by_rounding = [&] {
      return -e.height <= tolerances.touching * e.size &&
             same_direction(other.normal, e.normal, tolerances.same_direction);
    };
    if (in_front && other.opposition >= tolerances.competing * e.opposition && !behind_by_rounding() &&
        !concave(scene.faces, scene.motion, e, other, tolerances))
      return false;
    if (near_rim) continue;
    has_neighbour = true;
    const auto in_one_place = [&] { return (other.point - e.point).norm() <= tolerances.touching * e.size; };
    behind_all = behind_all && !in_front && (other.region == Region::face || in_one_place());
  }
  return near_rim || (has_neighbour && behind_all);
}

/// Is a node behind encounters[i] outside of the body all the same? At an edge sharper than a right angle it may be
/// behind one face, with its foot on it, and in front of the other: that one is what it meets.
bool is_outside_of_a_sharp_edge(std::span<const MasterFace> faces, const Tolerances& tolerances,
                                std::span<const Encounter> encounters, std::size_t i) {
  const Encounter& e = encounters[i];
  const MasterFace& face = faces[static_cast<std::size_t>(e.face)];
  return std::ranges::any_of(encounters, [&](const Encounter& other) {
    if (!(other.height > 0) || other.opposition < tolerances.competing * e.opposition) return false;
    if (same_direction(other.normal, e.normal, tolerances.same_direction)) return false;
    const Vec3 apart = other.point - e.point;
    const bool as_deep = apart.dot(e.normal) < tolerances.competing * e.height;  // it has a point as deep as the node
    const bool convex =
        -apart.dot(other.normal) <= tolerances.touching * e.size;  // a dent between warped faces is none
    // one node is enough: near a node of a ridge, faces meet across it that share no more
    return as_deep && convex && shared_nodes(face, faces[static_cast<std::size_t>(other.face)]) >= 1;
  });
}

/// The corners of the face as the node sees it: counter-clockwise from its side, moved out by the clearance.
void seen_from(const Approach& approach, std::span<Vec3> corners) {
  if (approach.side < 0) std::reverse(corners.begin(), corners.end());
  if (approach.clearance == 0) return;
  const Vec3 out = approach.clearance * geometry::area_vector(corners).normalized();
  for (Vec3& corner : corners) corner += out;
}

}  // namespace

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
  const MasterFace& face = scene.faces[static_cast<std::size_t>(met.face)];
  const auto count = static_cast<std::size_t>(face.corner_count);
  std::array<Vec3, 4> start, end;
  for (std::size_t i = 0; i < count; ++i) {
    start[i] = corner_of(scene, face, i).position;
    end[i] = start[i] + scene.dt * corner_of(scene, face, i).predicted;
  }
  seen_from(met.approach, {start.data(), count});
  seen_from(met.approach, {end.data(), count});
  const geometry::MovingPoint point{slave.position, slave.position + scene.dt * slave.predicted};
  const geometry::MovingFace moving{{start.data(), count}, {end.data(), count}};
  if (!geometry::may_meet(point, geometry::sweep_of(moving))) return;
  auto hit = geometry::first_contact(point, moving);
  if (!hit) return;
  if (met.approach.side < 0) std::reverse(hit->weights.begin(), hit->weights.begin() + face.corner_count);
  const double approach = -hit->normal.dot(scene.dt * relative_velocity(scene, slave, face, hit->weights));
  if (!(approach > 0)) return;
  met.meeting = Meeting::hit;
  met.time = hit->tau;
  met.gap = hit->tau * approach;
  met.normal = hit->normal;
  met.point = hit->point - met.approach.clearance * hit->normal;
  met.weights = hit->weights;
}

Encounter encounter(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave,
                    LocalIndex face_index, const Approach& approach) {
  Encounter met{
      .face = face_index, .approach = approach, .size = scene.reach[static_cast<std::size_t>(face_index)].size};
  const MasterFace& face = scene.faces[static_cast<std::size_t>(face_index)];
  std::array<Vec3, 4> storage;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) storage[i] = corner_of(scene, face, i).position;
  const geometry::Corners corners(storage.data(), count);
  const auto closest = geometry::closest_point(slave.position, corners);
  if (!closest) return met;

  met.region = closest->region;
  met.point = closest->point;
  met.weights = closest->weights;
  met.normal = approach.side * geometry::face_normal(corners, closest->xi, closest->eta);
  const Vec3 relative = relative_velocity(scene, slave, face, met.weights);
  classify(stand(geometry::vec_of(slave.position), geometry::vec_of(met.point), geometry::vec_of(met.normal),
                 geometry::vec_of(relative), scene.dt),
           tolerances, face.element_depth, met);
  return met;
}

bool concave(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, const Encounter& a,
             const Encounter& b, const Tolerances& tolerances) {
  const auto centre = [&](const Encounter& e) {
    const MasterFace& face = faces[static_cast<std::size_t>(e.face)];
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
      sum += motion[static_cast<std::size_t>(face.nodes[i])].position;
    return Vec3(sum / face.corner_count);
  };
  return (centre(b) - a.point).dot(a.normal) > tolerances.rounding * b.size &&
         (centre(a) - b.point).dot(b.normal) > tolerances.rounding * a.size;
}

void resolve_rim_projections(const FacesInMotion& scene, const Tolerances& tolerances,
                             std::span<Encounter> encounters) {
  const bool smooth = one_direction(encounters, tolerances.same_direction);
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    Encounter& e = encounters[i];
    if (e.meeting != Meeting::inside && e.meeting != Meeting::above) continue;
    const bool holds =
        (e.region == Region::face || holds_at_rim(scene, tolerances, encounters, i)) &&
        (smooth || e.meeting == Meeting::above || !is_outside_of_a_sharp_edge(scene.faces, tolerances, encounters, i));
    if (!holds) e.meeting = Meeting::none;
  }
}

void detect_path_hits(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave,
                      std::span<Encounter> encounters) {
  double most = 0;
  for (const Encounter& e : encounters)
    if (!std::isnan(e.height)) most = std::max(most, e.opposition);
  const auto is_opposed = [&](const Encounter& e) { return e.height > 0 && e.opposition >= tolerances.slight * most; };
  for (Encounter& e : encounters) {
    const bool settled = e.meeting == Meeting::above && e.slow;
    if (is_opposed(e) && !settled) find_hit(scene, slave, e);
  }
  for (Encounter& e : encounters)
    if (e.meeting == Meeting::none && is_opposed(e)) join_hit(scene, tolerances, slave, encounters, e);
}

}  // namespace brunt::contact
