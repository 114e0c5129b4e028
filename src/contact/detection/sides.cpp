// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/sides.hpp"

#include <algorithm>

namespace brunt::contact {
namespace {

constexpr double unknown = 0;

double remembered_side(std::span<const HistoryRecord> remembered, GlobalIndex face) {
  const auto found = std::ranges::find_if(
      remembered, [&](const HistoryRecord& record) { return record.side != 0 && record.key.master == face; });
  return found == remembered.end() ? unknown : found->side;
}

/// +1 if the faces share an edge and their normals have the same orientation, -1 if the opposite one, 0 if they share
/// none.
double relative_orientation(const MasterFace& one, const MasterFace& other) {
  const auto corner = [](const MasterFace& face, std::int32_t i) { return nth(face.nodes, i % face.corner_count); };
  for (std::int32_t i = 0; i < one.corner_count; ++i)
    for (std::int32_t k = 0; k < other.corner_count; ++k) {
      if (corner(one, i) == corner(other, k + 1) && corner(one, i + 1) == corner(other, k)) return 1;
      if (corner(one, i) == corner(other, k) && corner(one, i + 1) == corner(other, k + 1)) return -1;
    }
  return 0;
}

/// The remembered side of a neighbouring face, in the orientation of this one.
double side_across_an_edge(const FacesInMotion& scene, std::span<const HistoryRecord> remembered,
                           std::span<const Encounter> encounters, const MasterFace& face) {
  for (const Encounter& other : encounters) {  // in the order of their keys
    const MasterFace& neighbour = scene.face(other);
    const double side = neighbour.two_sided ? remembered_side(remembered, neighbour.key) : unknown;
    if (side == unknown) continue;
    if (const double turned = relative_orientation(face, neighbour); turned != 0) return turned * side;
  }
  return unknown;
}

/// The side of the plane on which the node is, if its projection lies on the face. Beside the face the plane does not
/// decide, since it continues outside of the body beyond a convex edge; there a path through the face decides.
double side_at_first_sight(const FacesInMotion& scene, const NodeMotion& slave, const Encounter& e) {
  Encounter up = encounter(scene, slave, e.face, {1, e.approach.clearance});
  const double over_middle = up.height + e.approach.clearance;
  if (up.region == geometry::Region::face && over_middle != 0) return over_middle > 0 ? 1 : -1;
  Encounter down = up;
  down.approach.side = -1;
  find_hit(scene, slave, up);
  find_hit(scene, slave, down);
  if (up.meeting == Meeting::hit || down.meeting == Meeting::hit) {
    if (up.meeting != down.meeting) return up.meeting == Meeting::hit ? 1 : -1;
    return up.time <= down.time ? 1 : -1;
  }
  return over_middle >= 0 ? 1 : -1;
}

}  // namespace

void find_sides(const FacesInMotion& scene, const NodeMotion& slave, std::span<const HistoryRecord> remembered,
                std::span<Encounter> encounters) {
  for (Encounter& e : encounters) {
    const MasterFace& face = scene.face(e);
    if (!face.two_sided) continue;
    double side = remembered_side(remembered, face.key);
    if (side == unknown) side = side_across_an_edge(scene, remembered, encounters, face);
    if (side == unknown) side = side_at_first_sight(scene, slave, e);
    e.approach.side = side;
  }
}

}  // namespace brunt::contact
