// SPDX-License-Identifier: Apache-2.0
#include "mortar_step.hpp"

#include <algorithm>
#include <utility>

#include "comm/rendezvous.hpp"
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

/// Of each node the bodies with which it has rows. Collective.
void mark_held_nodes(Contact& contact) {
  StepData& step = contact.step;
  step.held.assign(contact.lists.nodes.gid.size(), {});
  for (std::size_t r = 0; r < contact.history.mortar.heads.size(); ++r)
    nth(step.held, nth(step.mortar_places, contact.history.mortar.terms.offsets[r]))
        .add(static_cast<std::int32_t>(contact.history.mortar.heads[r].key.master));
  contact.lists.exchange.share(as_doubles(step.held), held_bodies_width);
}

bool are_held(const Contact& contact, std::span<const LocalIndex> nodes, std::int32_t body) {
  return std::ranges::all_of(nodes, [&](LocalIndex node) { return nth(contact.step.held, node).has(body); });
}

/// The bodies with which a row of this rank has all facets of its slave, of each contact node.
std::vector<HeldBodies> surrounding_bodies(const Contact& contact) {
  std::vector<HeldBodies> bodies(contact.lists.nodes.gid.size());
  for (std::size_t r = 0; r < contact.history.mortar.heads.size(); ++r) {
    const LocalIndex own = nth(contact.step.mortar_places, contact.history.mortar.terms.offsets[r]);
    if (has_all_facets(contact, r, own))
      nth(bodies, own).add(static_cast<std::int32_t>(contact.history.mortar.heads[r].key.master));
  }
  return bodies;
}

/// Of each slave the bodies all of whose candidate faces mortar rows hold.
void mark_settled_faces(Contact& contact) {
  const Candidates& candidates = contact.lists.candidates;
  const std::vector<HeldBodies> surrounding = surrounding_bodies(contact);
  std::vector<char>& settled = contact.step.settled;
  settled.assign(candidates.faces.values.size(), 0);
  const auto face_at = [&](std::size_t k) -> const MasterFace& {
    return nth(contact.lists.faces, candidates.faces.values[k]);
  };
  for (std::size_t s = 0; s < candidates.slave.size(); ++s) {
    const auto begin = static_cast<std::size_t>(candidates.faces.offsets[s]),
               stop = static_cast<std::size_t>(candidates.faces.offsets[s + 1]);
    for (std::size_t first = begin, end = begin; first < stop; first = end) {
      const std::int32_t body = face_at(first).body;
      bool held = true;
      for (; end < stop && face_at(end).body == body; ++end) {
        const MasterFace& face = face_at(end);
        held = held && are_held(contact, std::span(face.nodes).first(static_cast<std::size_t>(face.corner_count)),
                                candidates.body[s]);
      }
      settled[first] = held || nth(surrounding, candidates.slave[s]).has(body) ? 1 : 0;
    }
  }
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

std::vector<GlobalIndex> keys_of_faces(const Surface& surface) {
  std::vector<GlobalIndex> keys;
  for (const SurfaceFace& face : surface.faces) keys.push_back(face.key);
  std::ranges::sort(keys);
  return keys;
}

/// Appends the nodes of faces whose key is not among these.
void append_nodes_of_others(const Surface& surface, std::span<const GlobalIndex> keys,
                            std::vector<GlobalIndex>& nodes) {
  for (const SurfaceFace& face : surface.faces) {
    if (std::ranges::binary_search(keys, face.key)) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
      nodes.push_back(nth(surface.gid, face.nodes[i]));
  }
}

/// Of faces that only one of the surfaces has, of all ranks, ascending. Collective.
std::vector<GlobalIndex> nodes_of_changed_faces(const Surface& before, const Surface& after,
                                                const comm::Communicator& ranks) {
  std::vector<GlobalIndex> nodes;
  append_nodes_of_others(before, keys_of_faces(after), nodes);
  append_nodes_of_others(after, keys_of_faces(before), nodes);
  sort_unique(nodes);
  const std::vector<std::vector<GlobalIndex>> to_all(static_cast<std::size_t>(ranks.size()), nodes);
  std::vector<GlobalIndex> of_all = comm::exchange(ranks, to_all).values;
  sort_unique(of_all);
  return of_all;
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

void forget_changed_rows(const Surface& before, Contact& contact) {
  const std::vector<GlobalIndex> changed = nodes_of_changed_faces(before, contact.surface, contact.ranks);
  const MortarHistory history = std::move(contact.history.mortar);
  MortarHistory& kept = contact.history.mortar;
  kept.clear();
  for (std::size_t r = 0; r < history.heads.size(); ++r) {
    const std::span<const MortarTerm> terms = history.terms.row(static_cast<LocalIndex>(r));
    const auto has_changed = [&](const MortarTerm& term) {
      return term.part != MortarPart::facet && std::ranges::binary_search(changed, term.id);
    };
    if (std::ranges::none_of(terms, has_changed)) kept.append(history.heads[r], terms);
  }
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
    const bool changed =
        renew_weights(scene_of(contact), contact.history.mortar, step.mortar_places, step.scratch.mortar);
    if (!contact.list_state.are_new && !contact.ranks.any(changed)) return;
    mark_held_nodes(contact);
    return mark_settled_faces(contact);
  }
  contact.history.mortar.clear();
  step.mortar_places.clear();
  step.held.clear();
  step.settled.clear();
}

void exchange_face_rows(Contact& contact, const StepView& view) {
  if (!contact.lists.mortar.any) return;
  StepData& step = contact.step;
  const auto of_faces = static_cast<std::ptrdiff_t>(step.rows.size());
  append_mortar_rows(view, scene_of(contact), step.mortar_places, contact.history.mortar, step.scratch.mortar,
                     step.rows);
  const auto begin = step.rows.begin(), end = begin + of_faces;
  step.rows.erase(std::remove_if(begin, end, [&](const Row& row) { return is_replaced(contact, row); }), end);
}

double area_of_mortar_row(const Contact& contact, const Row& row) {
  const std::vector<MortarHead>& heads = contact.history.mortar.heads;
  const auto head = std::ranges::lower_bound(heads, row.key, {}, &MortarHead::key);
  return head != heads.end() && head->key == row.key ? head->area : 0;
}

}  // namespace brunt::contact
