// SPDX-License-Identifier: Apache-2.0
#include "mortar_step.hpp"

#include <algorithm>

#include "contact/data/tolerances.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"
#include "memory.hpp"
#include "slave.hpp"

namespace brunt::contact {
namespace {

MortarScene scene_of(const Contact& contact) {
  return {contact.lists.mortar,
          contact.lists.faces,
          contact.lists.nodes.gid,
          contact.step.nodes.motion,
          *contact.derived.detection.tolerances,
          contact.derived.detection.accepted};
}

/// Whether the row has all facets of its slave.
bool has_all_facets(const Contact& contact, std::size_t row, LocalIndex own) {
  const std::span<const MortarTerm> terms = contact.history.mortar.terms.row(static_cast<LocalIndex>(row));
  const auto count = std::ranges::count(terms, MortarPart::facet, &MortarTerm::part);
  return contact.history.mortar.heads[row].whole > 0 &&
         static_cast<std::size_t>(count) == contact.surface.facets.row(surface_node_of(contact, own)).size();
}

/// Collective.
void mark_held_nodes(Contact& contact) {
  StepData& step = contact.step;
  step.held.assign(contact.lists.nodes.gid.size(), {});
  step.surrounded.assign(contact.lists.nodes.gid.size(), {});
  for (std::size_t r = 0; r < contact.history.mortar.heads.size(); ++r) {
    const auto body = static_cast<std::int32_t>(contact.history.mortar.heads[r].key.master);
    const LocalIndex own = nth(step.mortar_places, contact.history.mortar.terms.offsets[r]);
    nth(step.held, own).add(body);
    if (has_all_facets(contact, r, own)) nth(step.surrounded, own).add(body);
  }
  contact.lists.exchange.share(as_doubles(step.held), held_bodies_width);
}

bool are_held(const Contact& contact, std::span<const LocalIndex> nodes, std::int32_t body) {
  return std::ranges::all_of(nodes, [&](LocalIndex node) { return nth(contact.step.held, node).has(body); });
}

/// A kept row of the slave and the master's body whose normal faces as the row's does.
bool has_mortar_row(const Contact& contact, const Row& row) {
  const std::vector<MortarHead>& heads = contact.history.mortar.heads;
  const double facing = contact.derived.detection.tolerances->facing;
  auto head = std::ranges::lower_bound(
      heads, RowKey{.kind = RowKind::mortar, .slave = row.key.slave, .master = row.master_body}, {}, &MortarHead::key);
  for (; head != heads.end() && head->key.slave == row.key.slave && head->key.master == row.master_body; ++head)
    if (nth(contact.step.scratch.mortar.normal, head - heads.begin()).dot(row.normal) >= facing) return true;
  return false;
}

/// Of a node on a face.
bool is_replaced(const Contact& contact, const Row& row) {
  return has_mortar_row(contact, row) || are_held(contact, row.points().subspan(1), row.slave_body);
}

LocalIndex place_of(std::span<const GlobalIndex> gid, GlobalIndex node) {
  const auto found = std::ranges::lower_bound(gid, node);
  demand(found != gid.end() && *found == node, "nodes of kept mortar rows are contact nodes");
  return static_cast<LocalIndex>(found - gid.begin());
}

}  // namespace

std::vector<GlobalIndex> nodes_of_kept_rows(const MortarHistory& history) {
  std::vector<GlobalIndex> nodes;
  for (const MortarTerm& term : history.terms.values)
    if (term.part != MortarPart::facet) nodes.push_back(term.id);
  sort_unique(nodes);
  return nodes;
}

void place_kept_rows(Contact& contact) {
  const std::vector<MortarFacet>& facets = contact.lists.mortar.facets;
  std::vector<LocalIndex>& places = contact.step.mortar_places;
  places.clear();
  for (const MortarTerm& term : contact.history.mortar.terms.values) {
    if (term.part != MortarPart::facet) {
      places.push_back(place_of(contact.lists.nodes.gid, term.id));
      continue;
    }
    const auto found = std::ranges::lower_bound(facets, term.id, {}, &MortarFacet::key);
    demand(found != facets.end() && found->key == term.id, "facets of kept mortar rows are in the lists");
    places.push_back(static_cast<LocalIndex>(found - facets.begin()));
  }
}

void renew_mortar_rows(Contact& contact) {
  StepData& step = contact.step;
  if (contact.lists.mortar.any) {
    renew_weights(scene_of(contact), contact.history.mortar, step.mortar_places, step.scratch.mortar);
    return mark_held_nodes(contact);
  }
  contact.history.mortar.clear();
  step.mortar_places.clear();
  step.held.clear();
  step.surrounded.clear();
}

void exchange_face_rows(Contact& contact, const StepView& view) {
  if (!contact.lists.mortar.any) return;
  StepData& step = contact.step;
  std::vector<Row>& mortar = step.scratch.mortar_rows;
  mortar.clear();
  append_mortar_rows(view, scene_of(contact), step.mortar_places, contact.history.mortar, step.scratch.mortar, mortar);
  std::erase_if(step.rows, [&](const Row& row) { return is_replaced(contact, row); });
  step.rows.insert(step.rows.end(), mortar.begin(), mortar.end());
}

void drop_held_edges(const Contact& contact, std::size_t first, std::vector<Row>& rows) {
  if (!contact.lists.mortar.any) return;
  const auto is_held = [&](const Row& row) {
    return are_held(contact, row.points().first(2), row.master_body) ||
           are_held(contact, row.points().last(2), row.slave_body);
  };
  rows.erase(std::remove_if(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end(), is_held), rows.end());
}

double area_of_mortar_row(const Contact& contact, const Row& row) {
  const std::vector<MortarHead>& heads = contact.history.mortar.heads;
  const auto head = std::ranges::lower_bound(heads, row.key, {}, &MortarHead::key);
  return head != heads.end() && head->key == row.key ? head->area : 0;
}

}  // namespace brunt::contact
