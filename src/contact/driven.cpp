// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/driven.hpp"

#include <algorithm>

#include "brunt/contact/anchors.hpp"
#include "brunt/contact/contact.hpp"
#include "brunt/core/error.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {

/// Can no impulse of the row change its rate, since supports hold all its nodes along the normal?
bool Contact::is_driven(const Row& row) const {
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
    const Mobility& node = mobility_[static_cast<std::size_t>(row.nodes[i])];
    if (row.weights[i] != 0 && node.inverse_mass > 0 && node.is_free_along(row.normal)) return false;
  }
  return true;
}

/// The rows are in the order of their slaves, so that the first of a step has the lowest gid.
void Contact::watch_driven(double dt) {
  for (const Row& row : rows_) {
    if (row.gap >= 0 || row.is_edge() || row.cone != Cone::compression || !is_driven(row)) continue;
    const std::int32_t slave_block =
        surface_.blocks.row(lists_.nodes.surface_node[static_cast<std::size_t>(row.nodes[0])]).front();
    const auto master_block = row.is_wall() ? static_cast<std::int32_t>(row.master_key) : row.master_block;
    auto known = std::ranges::find_if(
        driven_, [&](const DrivenMeeting& meeting) { return meeting.is_of(slave_block, master_block); });
    if (known == driven_.end()) {
      if (-row.gap <= DrivenMeeting::share * size_of_master(row)) continue;
      driven_.push_back(meeting_of(row, slave_block, master_block));
      driven_.back().since = clock_ - dt;
      known = driven_.end() - 1;
    }
    known->depth = std::max(known->depth, -row.gap);
  }
}

double Contact::size_of_master(const Row& row) const {
  if (row.is_wall()) return settings_.detection.wall_size;
  const MasterFace* face = find_face(lists_.faces, faces_by_key_, row.master_key);
  demand(face != nullptr, "the face of a row is in the lists");
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face->corner_count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = motion_of_[static_cast<std::size_t>(face->nodes[i])].position;
  return geometry::longest_edge({corners.data(), count});
}

DrivenMeeting Contact::meeting_of(const Row& row, std::int32_t slave_block, std::int32_t master_block) const {
  DrivenMeeting meeting{.slave_block = slave_block, .master_block = master_block, .slave = row.slave_gid};
  if (row.is_wall()) return meeting;
  const MasterFace* face = find_face(lists_.faces, faces_by_key_, row.master_key);
  const auto count = static_cast<std::size_t>(face->corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    meeting.corners[i] = lists_.nodes.gid[static_cast<std::size_t>(face->nodes[i])];
    for (std::size_t k = 1; k < static_cast<std::size_t>(row.node_count); ++k)
      if (row.nodes[k] == face->nodes[i]) meeting.weights[i] = -row.weights[k];
  }
  return meeting;
}

}  // namespace brunt::contact
