// SPDX-License-Identifier: Apache-2.0
#include "detect.hpp"

#include <algorithm>
#include <limits>

#include "contact/births.hpp"
#include "contact/detection/separation.hpp"
#include "memory.hpp"
#include "tied_parts.hpp"

namespace brunt::contact {
namespace {

/// The ends of a slave edge may have their rows on other ranks.
void detect_crossing_edges(const DetectionSettings& settings, double dt, ContactLists& lists, StepData& step) {
  std::vector<NodeHold>& holds = step.scratch.holds;
  holds.assign(lists.nodes.gid.size(), {});
  for (const Row& row : step.rows) {
    NodeHold& hold = holds[static_cast<std::size_t>(row.nodes[0])];
    if (hold.normal.isZero(0)) hold = {row.normal, static_cast<double>(row.master_body)};
  }
  lists.exchange.share(as_doubles(holds), hold_width);
  detect_edges(lists.edges, lists.nodes.gid, step.nodes.motion, step.scratch.detection.facet_normal, holds,
               step.nodes.reference, dt, settings, step.rows);
}

double measured_separation(const Contact& contact, const StepInput& input) {
  const ContactLists& lists = contact.lists;
  const DetectionSettings& settings = contact.derived.detection;
  const std::vector<NodeMotion>& motion = contact.step.nodes.motion;
  double least = contact.tied.ties.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  least =
      std::min(least, separation_of_faces(lists.candidates, contact.step.scratch.detection.reach, motion, input.dt));
  least = std::min(least, separation_of_edges(lists.edges, motion, input.dt, settings));
  least = std::min(least, separation_of_walls(lists.wall_candidates, input.walls, motion, input.dt, settings));
  return contact.ranks.min(least);
}

}  // namespace

/// The same on every rank, as the bounds of motion are.
bool nothing_can_meet(const Contact& contact) {
  const ListState& state = contact.list_state;
  return !contact.lists.any_rows || (!state.are_new && 3 * state.motion.bound() < state.separation);
}

void find_rows(Contact& contact, const StepInput& input) {
  const double dt = input.dt;
  const DetectionSettings& settings = contact.derived.detection;
  ContactLists& lists = contact.lists;
  StepData& step = contact.step;
  detect_faces(lists.candidates, lists.faces, lists.nodes.gid, step.nodes.motion, step.facet_area, dt, settings,
               contact.history.pairs, step.scratch.detection, step.rows, contact.history.births);
  if (contact.elements_are_gone) {
    const BirthScene births{contact.history.pairs, step.nodes.motion, dt, contact.births_due};
    follow_births(births, step.rows, contact.history.births, step.scratch.births);
  }
  contact.births_due = false;
  if (lists.any_edges) detect_crossing_edges(settings, dt, lists, step);
  if (contact.derived.tied) drop_tied_rows(contact, step.rows);
  detect_walls(lists.wall_candidates, input.walls, lists.nodes.gid, step.nodes.motion, dt, settings, step.rows);
  double& penetration = contact.ledger.sums.penetration;
  for (const Row& row : step.rows) penetration = std::max(penetration, -row.gap);
  append_tie_rows(contact, carriers_of(contact, input), dt, step.rows);
  sort_rows(step.rows, step.scratch.row_sort);
}

void detect_rows(Contact& contact, const StepInput& input) {
  find_rows(contact, input);
  if (contact.list_state.are_new) contact.list_state.separation = measured_separation(contact, input);
}

}  // namespace brunt::contact
