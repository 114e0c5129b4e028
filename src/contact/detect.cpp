// SPDX-License-Identifier: Apache-2.0
#include "detect.hpp"

#include <algorithm>
#include <limits>

#include "contact/births.hpp"
#include "contact/detection/separation.hpp"
#include "memory.hpp"
#include "mortar_step.hpp"
#include "tied_parts.hpp"

namespace brunt::contact {
namespace {

StepView view_of(const Contact& contact, double dt) {
  return {contact.lists.nodes.gid, contact.step.nodes.motion, dt, contact.derived.detection};
}

/// The ends of a slave edge may have their rows on other ranks.
void detect_crossing_edges(const StepView& view, ContactLists& lists, StepData& step) {
  std::vector<NodeHold>& holds = step.scratch.holds;
  holds.assign(lists.nodes.gid.size(), {});
  for (const Row& row : step.rows) {
    NodeHold& hold = nth(holds, row.nodes[0]);
    if (hold.normal.isZero(0)) hold = {row.normal, static_cast<double>(row.master_body)};
  }
  lists.exchange.share(as_doubles(holds), hold_width);
  detect_edges(view, {lists.edges, step.scratch.detection.facet_normal, holds, step.nodes.reference, step.held},
               step.rows);
}

double measured_separation(const Contact& contact, const StepInput& input) {
  const ContactLists& lists = contact.lists;
  if (lists.mortar.any) return 0;  // weights are integrated as soon as faces are near
  const StepView view = view_of(contact, input.dt);
  const bool tied = !contact.tied.ties.empty() || !contact.tied.mortar.rows.empty();
  double least = tied ? 0.0 : std::numeric_limits<double>::infinity();
  least = std::min(least, separation_of_faces(view, lists.candidates, contact.step.scratch.detection.reach));
  least = std::min(least, separation_of_edges(view, lists.edges));
  least = std::min(least, separation_of_walls(view, lists.wall_candidates, input.walls));
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
  const StepView view = view_of(contact, dt);
  ContactLists& lists = contact.lists;
  StepData& step = contact.step;
  if (contact.derived.mortar) renew_mortar_rows(contact);
  detect_faces(view,
               {lists.candidates, lists.faces, step.facet_area, contact.history.pairs, contact.history.births,
                step.held, step.settled},
               step.scratch.detection, step.rows);
  if (contact.derived.mortar) exchange_face_rows(contact, view);
  if (contact.elements_are_gone || contact.derived.mortar) {  // nodes that mortar rows have left may lie behind faces
    const BirthScene births{contact.history.pairs, step.nodes.motion, dt, contact.births_due, contact.derived.mortar};
    follow_births(births, step.rows, contact.history.births, step.scratch.births);
  }
  contact.births_due = false;
  if (lists.any_edges) detect_crossing_edges(view, lists, step);
  if (contact.derived.tied) drop_tied_rows(contact, step.rows);
  detect_walls(view, lists.wall_candidates, input.walls, step.rows);
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
