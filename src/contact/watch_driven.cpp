// SPDX-License-Identifier: Apache-2.0
#include "watch_driven.hpp"

#include <algorithm>

#include "brunt/contact/anchors.hpp"
#include "brunt/contact/data/tolerances.hpp"
#include "brunt/core/error.hpp"
#include "brunt/geometry/closest_point.hpp"
#include "slave.hpp"

namespace brunt::contact {
namespace {

/// Can no impulse of the row change its rate, since supports hold all its nodes along the normal?
bool is_driven(const Row& row, const ContactNodes& nodes, const Carriers& carriers) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
    const auto place = static_cast<std::size_t>(row.nodes[i]);
    const Mobility& node = nodes.mobility[place];
    if (const Carrier* body = carriers.of(row.nodes[i]))
      if (row.weights[i] != 0 && row.normal.dot(answer_at(*body, nodes.motion[place].position) * row.normal) > 0)
        return false;
    if (row.weights[i] != 0 && node.inverse_mass > 0 && node.is_free_along(row.normal)) return false;
  }
  return true;
}

const MasterFace& face_of(const Contact& contact, const Row& row) {
  const MasterFace* face = find_face(contact.lists.faces, contact.list_state.faces_by_key, row.key.master);
  demand(face != nullptr, "the face of a row is in the lists");
  return *face;
}

double size_of_master(const Contact& contact, const Row& row) {
  if (row.is_wall()) return contact.derived.detection.wall_size;
  const MasterFace& face = face_of(contact, row);
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i)
    corners[i] = contact.step.nodes.motion[static_cast<std::size_t>(face.nodes[i])].position;
  return geometry::longest_edge({corners.data(), count});
}

DrivenMeeting meeting_of(const Contact& contact, const Row& row, std::int32_t slave_block, std::int32_t master_block) {
  DrivenMeeting meeting{.slave_block = slave_block, .master_block = master_block, .slave = row.key.slave};
  if (row.is_wall()) return meeting;
  const MasterFace& face = face_of(contact, row);
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    meeting.corners[i] = contact.lists.nodes.gid[static_cast<std::size_t>(face.nodes[i])];
    for (std::size_t k = 1; k < static_cast<std::size_t>(row.node_count); ++k)
      if (row.nodes[k] == face.nodes[i]) meeting.weights[i] = -row.weights[k];
  }
  return meeting;
}

}  // namespace

/// The rows are in the order of their slaves, so that the first of a step has the lowest gid.
void watch_driven(Contact& contact, const Carriers& carriers, double dt) {
  std::vector<DrivenMeeting>& driven = contact.driven;
  const double ten_ledges = 10 * contact.derived.detection.tolerances->ledge;  // flush bodies settle by one
  for (const Row& row : contact.step.rows) {
    if (row.gap >= 0 || row.is_edge() || row.cone != Cone::compression || !is_driven(row, contact.step.nodes, carriers))
      continue;
    const std::int32_t slave_block = blocks_of_slave(contact, row).front();
    const auto master_block = row.is_wall() ? static_cast<std::int32_t>(-1 - row.key.master) : row.master_block;
    auto known = std::ranges::find_if(
        driven, [&](const DrivenMeeting& meeting) { return meeting.is_of(slave_block, master_block); });
    if (known == driven.end()) {
      if (-row.gap <= ten_ledges * size_of_master(contact, row)) continue;
      driven.push_back(meeting_of(contact, row, slave_block, master_block));
      driven.back().since = contact.ledger.clock - dt;
      known = driven.end() - 1;
    }
    known->penetration = std::max(known->penetration, -row.gap);
  }
}

}  // namespace brunt::contact
