// SPDX-License-Identifier: Apache-2.0
#include "initial_state.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "comm/rendezvous.hpp"
#include "detect.hpp"
#include "gather.hpp"
#include "rebuild_lists.hpp"
#include "tied_parts.hpp"

namespace brunt::contact {
namespace {

constexpr double any_step = 1;

BodyPair bodies_of(std::int32_t a, std::int32_t b) {
  return std::minmax(a, b);
}

/// The deepest of each (slave, master body) of this rank's rows, between bodies that keep their overlaps.
std::vector<AcceptedOverlap> overlaps_of(std::span<const Row> rows, const std::set<BodyPair>& keep) {
  std::vector<AcceptedOverlap> seen;
  for (const Row& row : rows) {
    if (row.is_wall() || row.is_edge() || row.gap >= 0) continue;
    if (!keep.contains(bodies_of(row.slave_body, row.master_body))) continue;
    if (!seen.empty() && seen.back().slave == row.key.slave && seen.back().body == row.master_body)
      seen.back().penetration = std::max(seen.back().penetration, -row.gap);
    else
      seen.push_back({row.key.slave, row.master_body, -row.gap, row.slave_body});
  }
  return seen;
}

/// Lists and positions of contact nodes as they are before anything moves.
void gather_start(Contact& contact, const std::vector<Vec3>& reference, std::span<const Wall> walls,
                  FacetPairs facets) {
  std::vector<Vec3> still(reference.size(), Vec3::Zero());
  const MutableVectorView velocity{reinterpret_cast<double*>(still.data())};
  const StepInput input{.position = {reinterpret_cast<const double*>(reference.data())},
                        .old_velocity = {velocity.data},
                        .velocity = velocity,
                        .walls = walls,
                        .dt = any_step};
  rebuild(contact, input, facets);
  if (contact.lists.any_rows) gather(input, contact.list_state.gather, contact.lists, contact.step);
}

void forget_start(Contact& contact) {
  contact.step.rows.clear();
  contact.ledger.sums.penetration = 0;
  contact.ledger.statistics = {};
  contact.list_state.exist = false;
}

}  // namespace

/// The accepted overlaps name the bodies that keep theirs. Geometry alone does not know all of their nodes: one that
/// is outside of a facetted end may be at the rim of its face to detection, or be behind another face.
void keep_overlaps(Contact& contact, const std::vector<Vec3>& reference, std::span<const Wall> walls) {
  if (contact.settings.detection.accepted.empty()) return;
  std::set<BodyPair> keep;
  std::map<std::pair<GlobalIndex, std::int32_t>, AcceptedOverlap> all;
  for (const AcceptedOverlap& overlap : contact.settings.detection.accepted) {
    keep.insert(bodies_of(overlap.slave_body, overlap.body));
    all[{overlap.slave, overlap.body}] = overlap;
  }
  std::vector<AcceptedOverlap>& accepted = contact.derived.detection.accepted;
  accepted.clear();
  gather_start(contact, reference, walls, contact.derived.mortar ? FacetPairs::mortar : FacetPairs::none);
  const StepInput at_rest{.position = {}, .old_velocity = {}, .velocity = {}, .walls = walls, .dt = any_step};
  if (contact.lists.any_rows) find_rows(contact, at_rest);
  const std::vector<std::vector<AcceptedOverlap>> to_all(static_cast<std::size_t>(contact.ranks.size()),
                                                         overlaps_of(contact.step.rows, keep));
  for (const AcceptedOverlap& overlap : comm::exchange(contact.ranks, to_all).values)
    all[{overlap.slave, overlap.body}] = overlap;
  for (const auto& [key, overlap] : all) accepted.push_back(overlap);
  contact.derived.detection.fitted.assign(keep.begin(), keep.end());
  forget_start(contact);
}

void make_ties(Contact& contact, const std::vector<Vec3>& reference, std::span<const Wall> walls) {
  if (!contact.derived.tied) return;
  gather_start(contact, reference, walls, FacetPairs::tied);
  contact.tied = find_tied_parts(contact);
  forget_start(contact);
}

void renew_ties(Contact& contact, const std::vector<Vec3>& reference, std::span<const mesh::ExteriorFace> faces) {
  if (!contact.derived.tied) return;
  std::vector<TiedPair> pairs = pairs_left(contact, faces);
  if (!contact.ranks.any(pairs != contact.tied.pairs_in_use)) return;
  contact.tied.mortar = {};
  const ContactStatistics before = contact.ledger.statistics;
  gather_start(contact, reference, contact.walls_at_start, FacetPairs::tied);
  contact.tied.mortar = find_mortar_ties(contact, &pairs);
  contact.tied.pairs_in_use = std::move(pairs);
  contact.ledger.statistics = before;
}

}  // namespace brunt::contact
