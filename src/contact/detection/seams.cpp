// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/seams.hpp"

#include <Eigen/Geometry>

#include "contact/data/tolerances.hpp"
#include "edge_scene.hpp"

namespace brunt::contact {
namespace {

const MasterFace& face_of(const FacesInMotion& scene, const Encounter& e) {
  return scene.faces[static_cast<std::size_t>(e.face)];
}

/// Whether another face continues from `top` beyond an edge in which `side` ends. The face of the node may be the next
/// one along the seam: then they have only a corner in common.
bool continues_beyond(const FacesInMotion& scene, const Tolerances& tolerances, const Encounter& top,
                      const Encounter& side) {
  const MasterFace &above = face_of(scene, top), &below = face_of(scene, side);
  const auto count = static_cast<std::size_t>(above.corner_count);
  const std::span<const LocalIndex> corners(below.nodes.data(), static_cast<std::size_t>(below.corner_count));
  const auto is_corner = [&](LocalIndex node) { return std::ranges::find(corners, node) != corners.end(); };
  const auto place = [&](LocalIndex node) { return scene.motion[static_cast<std::size_t>(node)].position; };
  for (std::size_t i = 0; i < count; ++i) {
    const LocalIndex from = above.nodes[i], to = above.nodes[(i + 1) % count];
    if ((above.seams >> i & 1U) == 0 || !(is_corner(from) || is_corner(to))) continue;
    if ((place(to) - place(from)).cross(top.normal).normalized().dot(side.normal) > tolerances.facing) return true;
  }
  return false;
}

/// Sag of a seam of the slave's own whose face lies on the one with this normal [length]; 0: none.
double own_sag(const OwnFacets& own, const Vec3& normal, const Tolerances& tolerances) {
  double sag = 0;
  for (std::size_t i = 0; i < own.seam_sag.size(); ++i)
    if (own.facet_normal[static_cast<std::size_t>(own.facets[i])].dot(normal) < -tolerances.facing)
      sag = std::max(sag, own.seam_sag[i]);
  return sag;
}

/// A face that is itself the side of a seam is never the top: that of a tile among tiles, on which a node stands close
/// to its rim.
bool is_side_of_seam(const FacesInMotion& scene, const Tolerances& tolerances, const OwnFacets& own,
                     const Encounter& side, const Encounter& top) {
  if (continues_beyond(scene, tolerances, side, top)) return false;
  const MasterFace &above = face_of(scene, top), &below = face_of(scene, side);
  double sag = own_sag(own, top.normal, tolerances);
  if (continues_beyond(scene, tolerances, top, side))
    sag = std::max(sag, tolerances.max_penetration(top.size, above.element_depth));
  if (sag == 0 || !(std::abs(top.height) <= sag) || top.opposition < tolerances.competing * side.opposition)
    return false;
  return !contact::same_direction(side.normal, top.normal, tolerances.same_direction) &&
         shared_nodes(below, above) >= 1 && !concave(scene.faces, scene.motion, side, top, tolerances);
}

/// A node at the rim of the continuing face, in the seam, is in contact with that face: the side before it is no face.
void meet_at_rim(const FacesInMotion& scene, const Tolerances& tolerances, Encounter& top) {
  const double rim = tolerances.rim * std::min(top.size, face_of(scene, top).element_depth);
  if (top.meeting == Meeting::none && top.beside <= rim && top.height <= 0 && -top.height <= rim)
    top.meeting = Meeting::inside;
}

/// Of an edge that ends below a seam, the faces that are its sides begin where `other` is too deep below the end: up to
/// there its normal cone is what of it is left without them. out: the meeting's normal, out of the edge.
bool is_at_end_below_seam(const EdgeScene& scene, const ContactEdge& edge, const ContactEdge& other, const Vec3& out) {
  const double sag = scene.tolerances().max_penetration(scene.length(edge), edge.element_depth);
  for (std::size_t end = 0; end < 2; ++end) {
    const std::array<bool, 2>& at_side = edge.end_at_side[end];
    if (!at_side[0] && !at_side[1]) continue;
    const Vec3& top = scene.at(edge.nodes[end]).position;
    const Vec3 down = (scene.at(edge.nodes[1 - end]).position - top).normalized();
    const auto reaches_below = [&](LocalIndex node) { return (scene.at(node).position - top).dot(down) > sag; };
    const auto is_left = [&](std::size_t k) {
      return !at_side[k] && out.dot(scene.normal(edge, k)) > scene.tolerances().aligned;
    };
    if (!is_left(0) && !is_left(1) && std::ranges::none_of(other.nodes, reaches_below)) return true;
  }
  return false;
}

/// out: the meeting's normal, out of the seam's edge.
bool is_at_side(const EdgeScene& scene, const ContactEdge& seam, const ContactEdge& other, const Vec3& point,
                const Vec3& out) {
  const double sag = scene.tolerances().max_penetration(scene.length(seam), seam.element_depth);
  for (std::size_t k = 0; k < 2; ++k) {
    if (!seam.seam[k]) continue;
    const Vec3 top = scene.normal(seam, k);
    if (out.dot(top) > scene.tolerances().aligned) return false;
    const auto reaches_below = [&](LocalIndex node) { return (scene.at(node).position - point).dot(top) < -sag; };
    if (std::ranges::none_of(other.nodes, reaches_below)) return true;
  }
  return false;
}

}  // namespace

void remove_seam_sides(const FacesInMotion& scene, const Tolerances& tolerances, const OwnFacets& own,
                       std::span<Encounter> encounters) {
  if (one_direction(encounters, tolerances.same_direction)) return;  // nearly always
  for (Encounter& side : encounters) {
    if (side.meeting == Meeting::none) continue;
    for (Encounter& top : encounters) {
      if (&top == &side || !is_side_of_seam(scene, tolerances, own, side, top)) continue;
      side.meeting = Meeting::none;
      meet_at_rim(scene, tolerances, top);
    }
  }
}

bool meet_at_side_of_seam(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master,
                          const EdgeMeeting& met) {
  if (!seams_count(scene.settings, slave.body, master.body)) return false;
  const geometry::Segment own = scene.start(slave), other = scene.start(master);
  if (is_at_end_below_seam(scene, master, slave, met.normal) || is_at_end_below_seam(scene, slave, master, -met.normal))
    return true;
  return is_at_side(scene, master, slave, (1 - met.t) * other.start + met.t * other.end, met.normal) ||
         is_at_side(scene, slave, master, (1 - met.s) * own.start + met.s * own.end, -met.normal);
}

}  // namespace brunt::contact
