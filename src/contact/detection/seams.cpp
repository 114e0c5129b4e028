// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/seams.hpp"

#include <Eigen/Geometry>

#include "contact/data/tolerances.hpp"
#include "edge_scene.hpp"

namespace brunt::contact {
namespace {

/// Whether another face continues from `top` beyond an edge at which the lateral face begins. The node may be at the
/// next face along the seam: then both have only a corner in common.
bool continues_beyond(const FacesInMotion& scene, const Encounter& top, const Encounter& lateral) {
  const MasterFace &above = scene.face(top), &below = scene.face(lateral);
  const auto count = static_cast<std::size_t>(above.corner_count);
  const auto place = [&](LocalIndex node) { return scene.node(node).position; };
  for (std::size_t i = 0; i < count; ++i) {
    const LocalIndex from = above.nodes[i], to = above.nodes[(i + 1) % count];
    if ((above.seams >> i & 1U) == 0 || !(has_node(below, from) || has_node(below, to))) continue;
    const Vec3 beyond = (place(to) - place(from)).cross(top.normal).normalized();
    if (beyond.dot(lateral.normal) > scene.tolerances.facing) return true;
  }
  return false;
}

/// Possible settlement at a seam of the slave's own body whose face lies on the master face with this normal [length];
/// 0: there is none.
double own_sag(const OwnFacets& own, const Vec3& normal, const Tolerances& tolerances) {
  double sag = 0;
  for (std::size_t i = 0; i < own.seam_sag.size(); ++i)
    if (nth(own.facet_normal, own.facets[i]).dot(normal) < -tolerances.facing) sag = std::max(sag, own.seam_sag[i]);
  return sag;
}

/// Whether `top` continues beyond the edge at which the lateral face begins, and the node is within the settlement of
/// its plane. A face that is itself the lateral face of a seam never counts as top: such a face exists between tiles,
/// near whose edges a node may stand.
bool is_lateral_face_of_seam(const FacesInMotion& scene, const OwnFacets& own, const Encounter& lateral,
                             const Encounter& top) {
  const Tolerances& tolerances = scene.tolerances;
  if (continues_beyond(scene, lateral, top)) return false;
  const MasterFace &above = scene.face(top), &below = scene.face(lateral);
  double sag = own_sag(own, top.normal, tolerances);
  if (continues_beyond(scene, top, lateral))
    sag = std::max(sag, tolerances.max_penetration(top.size, above.element_depth));
  if (sag == 0 || !(std::abs(top.height) <= sag) || top.opposition < tolerances.competing * lateral.opposition)
    return false;
  return !same_direction(lateral.normal, top.normal, tolerances.same_direction) && shared_nodes(below, above) >= 1 &&
         !concave(scene, lateral, top);
}

/// A node in the seam, at the rim of the continuing face, is in contact with that face, since the lateral face does not
/// act.
void meet_at_rim(const FacesInMotion& scene, Encounter& top) {
  const double rim = scene.tolerances.rim * std::min(top.size, scene.face(top).element_depth);
  if (top.meeting == Meeting::none && top.beside <= rim && top.height <= 0 && -top.height <= rim)
    top.meeting = Meeting::inside;
}

/// Whether the edge ends at a seam above, and the other edge does not reach deeper below that end than the settlement.
/// The faces of the edge that are lateral faces of the seam begin there, so the normal cone consists of the remaining
/// ones. out: normal of the meeting, out of the edge.
bool is_at_end_below_seam(const EdgeScene& scene, const ContactEdge& edge, const ContactEdge& other, const Vec3& out) {
  const double sag = scene.tolerances().max_penetration(scene.length(edge), edge.element_depth);
  for (std::size_t end = 0; end < 2; ++end) {
    const std::array<bool, 2>& is_lateral = edge.end_at_side[end];
    if (!is_lateral[0] && !is_lateral[1]) continue;
    const Vec3& top = scene.at(edge.nodes[end]).position;
    const Vec3 down = (scene.at(edge.nodes[1 - end]).position - top).normalized();
    const auto reaches_below = [&](LocalIndex node) { return (scene.at(node).position - top).dot(down) > sag; };
    const auto remaining_face_is_met = [&](std::size_t k) {
      return !is_lateral[k] && out.dot(scene.normal(edge, k)) > scene.tolerances().aligned;
    };
    if (!remaining_face_is_met(0) && !remaining_face_is_met(1) && std::ranges::none_of(other.nodes, reaches_below))
      return true;
  }
  return false;
}

/// Whether the edges meet at the lateral face of the seam that the first one forms, and the other one does not reach
/// deeper below the continuing face than the settlement. point: of the meeting; out: its normal, out of the seam's
/// edge.
bool is_at_lateral_face(const EdgeScene& scene, const ContactEdge& seam, const ContactEdge& other, const Vec3& point,
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

void remove_lateral_faces_of_seams(const FacesInMotion& scene, const OwnFacets& own, std::span<Encounter> encounters) {
  if (one_direction(encounters, scene.tolerances.same_direction)) return;  // the usual case
  for (Encounter& lateral : encounters) {
    if (lateral.meeting == Meeting::none) continue;
    for (Encounter& top : encounters) {
      if (&top == &lateral || !is_lateral_face_of_seam(scene, own, lateral, top)) continue;
      lateral.meeting = Meeting::none;
      meet_at_rim(scene, top);
    }
  }
}

bool meet_at_lateral_face_of_seam(const EdgeScene& scene, const EdgePair& pair, const EdgeMeeting& met) {
  const auto& [slave, master, size] = pair;
  if (!seams_count(scene.settings, slave.body, master.body)) return false;
  const geometry::Segment own = scene.start(slave), other = scene.start(master);
  if (is_at_end_below_seam(scene, master, slave, met.normal) || is_at_end_below_seam(scene, slave, master, -met.normal))
    return true;
  return is_at_lateral_face(scene, master, slave, (1 - met.t) * other.start + met.t * other.end, met.normal) ||
         is_at_lateral_face(scene, slave, master, (1 - met.s) * own.start + met.s * own.end, -met.normal);
}

}  // namespace brunt::contact
