// SPDX-License-Identifier: Apache-2.0
// Overlaps of the start that the scene keeps, as detection sees them: the same faces and normals as in a step.
#include <algorithm>
#include <map>
#include <set>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/contact/contact.hpp"

namespace brunt::contact {
namespace {

BodyPair bodies_of(std::int32_t a, std::int32_t b) {
  return std::minmax(a, b);
}

/// The deepest of each (slave, master body) of this rank's rows, between bodies that keep their overlaps.
std::vector<AcceptedOverlap> overlaps_of(std::span<const Row> rows, const std::set<BodyPair>& keep) {
  std::vector<AcceptedOverlap> seen;
  for (const Row& row : rows) {
    if (row.is_wall() || row.is_edge() || row.gap >= 0) continue;
    if (!keep.contains(bodies_of(row.slave_body, row.master_body))) continue;
    if (!seen.empty() && seen.back().slave == row.slave_gid && seen.back().body == row.master_body)
      seen.back().depth = std::max(seen.back().depth, -row.gap);
    else
      seen.push_back({row.slave_gid, row.master_body, -row.gap, row.slave_body});
  }
  return seen;
}

}  // namespace

/// Lists and positions of contact nodes as they are before anything moves.
void Contact::look_at_start(const std::vector<Vec3>& reference, std::span<const Wall> walls) {
  constexpr double any_step = 1;
  std::vector<Vec3> still(reference.size(), Vec3::Zero());
  const VectorView position{reinterpret_cast<const double*>(reference.data())};
  const MutableVectorView velocity{reinterpret_cast<double*>(still.data())};
  rebuild(position, {velocity.data}, walls, any_step);
  if (lists_.any_rows) gather(position, {velocity.data}, velocity);
}

void Contact::forget_start() {
  rows_.clear();
  sums_.penetration = 0;
  statistics_ = {};
  have_lists_ = false;
}

/// What was accepted tells which bodies keep their overlaps. Geometry alone does not know all of their nodes: one that
/// is outside of a facetted end may be at the rim of its face to detection, or be behind another face.
void Contact::keep_overlaps(const std::vector<Vec3>& reference, std::span<const Wall> walls) {
  std::vector<AcceptedOverlap>& accepted = settings_.detection.accepted;
  if (accepted.empty()) return;
  std::set<BodyPair> keep;
  std::map<std::pair<GlobalIndex, std::int32_t>, AcceptedOverlap> all;
  for (const AcceptedOverlap& overlap : accepted) {
    keep.insert(bodies_of(overlap.slave_body, overlap.body));
    all[{overlap.slave, overlap.body}] = overlap;
  }
  accepted.clear();
  look_at_start(reference, walls);
  constexpr double any_step = 1;
  if (lists_.any_rows) detect(walls, any_step);
  const std::vector<std::vector<AcceptedOverlap>> to_all(static_cast<std::size_t>(ranks_.size()),
                                                         overlaps_of(rows_, keep));
  for (const AcceptedOverlap& overlap : comm::exchange(ranks_, to_all).values)
    all[{overlap.slave, overlap.body}] = overlap;
  for (const auto& [key, overlap] : all) accepted.push_back(overlap);
  settings_.detection.fitted.assign(keep.begin(), keep.end());
  forget_start();
}

}  // namespace brunt::contact
