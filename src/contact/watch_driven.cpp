// SPDX-License-Identifier: Apache-2.0
#include "watch_driven.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/anchors/anchors.hpp"
#include "contact/data/tolerances.hpp"
#include "core/error.hpp"
#include "geometry/closest_point.hpp"
#include "slave.hpp"

namespace brunt::contact {
namespace {

/// Can no impulse of the row change its rate, since supports hold all its nodes along the normal?
bool is_driven(const Row& row, const ContactNodes& nodes, const Carriers& carriers) {
  for (std::size_t i = 0; i < row.points().size(); ++i) {
    const double share = row.shares()[i];
    const auto place = static_cast<std::size_t>(row.points()[i]);
    const Mobility& node = nodes.mobility[place];
    if (const Carrier* body = carriers.of(row.points()[i]))
      if (share != 0 && row.normal.dot(answer_at(*body, nodes.motion[place].position) * row.normal) > 0) return false;
    if (share != 0 && node.inverse_mass > 0 && node.is_free_along(row.normal)) return false;
  }
  return true;
}

/// The key names a face.
bool is_on_face(const Row& row) {
  return !row.is_wall() && !row.is_edge() && !row.is_mortar() && !row.is_mortar_tie();
}

const MasterFace& face_of(const Contact& contact, const Row& row) {
  const MasterFace* face = find_face(contact.lists.faces, contact.list_state.faces_by_key, row.key.master);
  demand(face != nullptr, "the face of a row is in the lists");
  return *face;
}

/// Size of the master; of an edge or several faces the mean one of the surface.
double size_of_master(const Contact& contact, const Row& row) {
  if (!is_on_face(row)) return contact.derived.detection.wall_size;
  const MasterFace& face = face_of(contact, row);
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = nth(contact.step.nodes.motion, face.nodes[i]).position;
  return geometry::longest_edge({corners.data(), count});
}

/// Shortest side of the rigid bodies of the row; infinite without them.
double extent_of_bodies(const Contact& contact, const Row& row) {
  const std::span<const CarriedPoint> points = contact.step.nodes.carried;
  double extent = std::numeric_limits<double>::infinity();
  for (const LocalIndex point : row.points()) {
    const auto found = std::ranges::lower_bound(points, point, {}, &CarriedPoint::point);
    if (found != points.end() && found->point == point)
      extent = std::min(extent, nth(contact.settings.rigid.extent, found->body));
  }
  return extent;
}

/// A share of a rigid body, but less than the depth in which contact sees its nodes; otherwise an element.
void set_limit(const Contact& contact, const Row& row, double size, DrivenMeeting& meeting) {
  const double extent = extent_of_bodies(contact, row);
  const bool behind_face = is_on_face(row);
  meeting.is_rigid = std::isfinite(extent);
  meeting.limit = size;
  if (behind_face) meeting.limit = face_of(contact, row).element_depth;
  if (!meeting.is_rigid) return;
  const double seen = contact.derived.detection.tolerances->max_penetration(size, meeting.limit);
  meeting.limit = unmet_numbers.share_of_body * extent;
  if (behind_face) meeting.limit = std::min(meeting.limit, unmet_numbers.share_of_sight * seen);
}

DrivenMeeting meeting_of(const Contact& contact, const Row& row, std::int32_t slave_block, std::int32_t master_block) {
  DrivenMeeting meeting{.slave_block = slave_block, .master_block = master_block, .slave = row.key.slave};
  if (!is_on_face(row)) return meeting;
  const MasterFace& face = face_of(contact, row);
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    meeting.corners[i] = nth(contact.lists.nodes.gid, face.nodes[i]);
    for (std::size_t k = 1; k < static_cast<std::size_t>(row.node_count); ++k)
      if (row.nodes[k] == face.nodes[i]) meeting.weights[i] = -row.weights[k];
  }
  return meeting;
}

/// Updates the list; returns the penetration over its limit if it is of a rigid body and grows, otherwise 0.
double watch_row(Contact& contact, const Row& row, bool in_chain, const StepInput& input) {
  std::vector<DrivenMeeting>& driven = contact.driven;
  const Tolerances& tolerances = *contact.derived.detection.tolerances;
  const std::int32_t slave_block = row.is_edge() ? row.slave_block : blocks_of_slave(contact, row).front();
  const auto master_block = row.is_wall() ? static_cast<std::int32_t>(-1 - row.key.master) : row.master_block;
  const double size = size_of_master(contact, row);
  auto known = std::ranges::find_if(
      driven, [&](const DrivenMeeting& meeting) { return meeting.is_of(slave_block, master_block); });
  if (known == driven.end()) {
    constexpr double settled = 10;  // flush bodies settle by one ledge
    if (-row.gap <= (in_chain ? 1 : settled) * tolerances.ledge * size) return 0;
    driven.push_back(meeting_of(contact, row, slave_block, master_block));
    known = driven.end() - 1;
    known->since = contact.ledger.clock - input.dt;
    known->in_chain = in_chain;
    set_limit(contact, row, size, *known);
  }
  known->penetration = std::max(known->penetration, -row.gap);
  DrivenMeeting now;  // whatever row was the first, as after a restart
  set_limit(contact, row, size, now);
  const double wall = row.is_wall() ? row.normal.dot(nth(input.walls, row.key.master).velocity) : 0.0;
  const double closing = wall - row.normal.dot(relative_velocity(row, contact.step.nodes.velocity));
  const bool grows = closing * input.dt > tolerances.fine_rounding * size;
  return now.is_rigid && grows ? -row.gap / now.limit : 0.0;
}

}  // namespace

/// The rows are in the order of their slaves, so that the first of a step has the lowest gid.
void watch_driven(Contact& contact, const StepInput& input) {
  const Carriers carriers = carriers_of(contact, input);
  double excess = 0;
  for (std::size_t q = 0; q < contact.step.rows.size(); ++q) {
    const Row& row = contact.step.rows[q];
    if (row.gap >= 0 || row.cone != Cone::compression) continue;
    const bool in_chain = contact.unmet.is(q);
    if (!in_chain && (row.is_edge() || !is_driven(row, contact.step.nodes, carriers))) continue;
    excess = std::max(excess, watch_row(contact, row, in_chain, input));
  }
  for (const Row& row : contact.unmet.jammed)
    if (row.gap < 0) excess = std::max(excess, watch_row(contact, row, true, input));
  if (!contact.derived.may_jam) return;
  contact.lists.exchange.max({&excess, 1});
  contact.unmet.excess = excess;
}

}  // namespace brunt::contact
