// SPDX-License-Identifier: Apache-2.0
#include "tied_parts.hpp"

#include <algorithm>

#include "comm/rendezvous.hpp"
#include "contact/anchors/mortar_ties.hpp"
#include "contact/data/tolerances.hpp"
#include "contact/mortar_rows/tie_weights.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"
#include "memory.hpp"
#include "slave.hpp"

namespace brunt::contact {
namespace {

const PairTable& pairs_of(const Contact& contact) {
  return contact.settings.specification.pairs;
}

/// Of arrays over pairs of blocks; none where no pair is tied.
std::size_t place_count(const Contact& contact) {
  const std::size_t blocks = pairs_of(contact).block_count();
  return contact.derived.tied ? blocks * blocks : 0;
}

TieScene tie_scene(const Contact& contact, double dt) {
  return {.candidates = contact.lists.candidates,
          .faces = contact.lists.faces,
          .by_key = contact.list_state.faces_by_key,
          .gid = contact.lists.nodes.gid,
          .motion = contact.step.nodes.motion,
          .recovery = contact.derived.detection.tolerances->recovery,
          .dt = dt};
}

/// Is the row's slave a node of blocks that have but their ties to do with the master's?
bool nothing_else_acts(const Contact& contact, const Row& row) {
  return std::ranges::all_of(blocks_of_slave(contact, row), [&](std::int32_t block) {
    const PairSpecification& pair = pairs_of(contact).at(block, row.master_block);
    return pair.tied == Tied::alone || pair.rule == PairRule::apart;
  });
}

/// Whether the node has facets that are covered.
bool has_facets_tied(const MortarTies& ties, GlobalIndex slave) {
  const auto found = std::ranges::lower_bound(ties.held, TiedNode{slave, 0});
  return found != ties.held.end() && found->first == slave;
}

/// Of the lists, those of the given pairs.
MortarCandidates candidates_of(const ContactLists& lists, const std::vector<TiedPair>* pairs) {
  MortarCandidates candidates = lists.mortar;
  if (pairs == nullptr) return candidates;
  candidates.masters.clear();
  for (std::size_t f = 0; f < candidates.facets.size(); ++f) {
    for (const LocalIndex face : lists.mortar.masters.row(static_cast<LocalIndex>(f)))
      if (std::ranges::binary_search(*pairs, TiedPair{candidates.facets[f].key, nth(lists.faces, face).key}))
        candidates.masters.values.push_back(face);
    candidates.masters.close_row();
  }
  return candidates;
}

}  // namespace

std::int32_t tied_block(const Contact& contact, LocalIndex slave, std::int32_t master_block) {
  for (const std::int32_t block : contact.surface.blocks.row(surface_node_of(contact, slave)))
    if (pairs_of(contact).at(block, master_block).tied != Tied::no) return block;
  return no_index;
}

TiedParts find_tied_parts(Contact& contact) {
  const ContactLists& lists = contact.lists;
  TiedParts parts;
  parts.mortar = find_mortar_ties(contact, nullptr);
  parts.pairs_at_start = parts.pairs_in_use = parts.mortar.pairs;
  const auto has_facets = [&](LocalIndex slave) { return has_facets_tied(parts.mortar, nth(lists.nodes.gid, slave)); };
  const auto block_of = [&](LocalIndex face) { return nth(lists.faces, face).block; };
  parts.nodes_beside.assign(place_count(contact), 0);
  parts.ties = find_ties(
      lists.candidates, lists.faces, lists.nodes.gid, contact.step.nodes.motion, contact.step.facet_area,
      *contact.derived.detection.tolerances,
      [&](LocalIndex slave, LocalIndex face) {
        return tied_block(contact, slave, block_of(face)) != no_index && !has_facets(slave);
      },
      [&](LocalIndex slave, LocalIndex face) {
        const std::int32_t block = tied_block(contact, slave, block_of(face));
        ++parts.nodes_beside[pairs_of(contact).place(block, block_of(face))];
      });
  parts.arms.resize(parts.ties.size());
  for (Tie& tie : parts.ties) {
    const auto slave = std::ranges::lower_bound(lists.nodes.gid, tie.slave) - lists.nodes.gid.begin();
    tie.slave_block = tied_block(contact, static_cast<LocalIndex>(slave), tie.block);
  }
  return parts;
}

TiedNodes tied_nodes(const Contact& contact) {
  TiedNodes count{std::vector<GlobalIndex>(place_count(contact), 0), contact.tied.nodes_beside};
  for (const Tie& tie : contact.tied.ties) ++count.tied[pairs_of(contact).place(tie.slave_block, tie.block)];
  for (const MortarTie& row : contact.tied.mortar.rows)
    if (row.number == 0) ++count.tied[pairs_of(contact).place(row.slave_block, row.block)];
  contact.ranks.sum(count.tied);
  contact.ranks.sum(count.beside);
  return count;
}

void release_ties(Contact& contact, std::span<const mesh::ExteriorFace> faces) {
  std::vector<Tie>& ties = contact.tied.ties;
  if (!contact.derived.tied) return;
  std::vector<GlobalIndex> keys;
  for (const Tie& tie : ties) keys.push_back(tie.face);
  const std::vector<GlobalIndex> left = keys_left(contact.ranks, std::move(keys), faces);
  const Surface& surface = contact.surface;
  std::erase_if(ties, [&](const Tie& tie) {
    const auto slave = std::ranges::lower_bound(surface.gid, tie.slave) - surface.gid.begin();
    const auto node = static_cast<LocalIndex>(slave);
    if (slave == std::ssize(surface.gid) || nth(surface.gid, slave) != tie.slave) return true;
    return !std::ranges::binary_search(left, tie.face) || surface.facets.row(node).empty() ||
           !std::ranges::binary_search(surface.blocks.row(node), tie.slave_block);
  });
  contact.tied.arms.resize(ties.size());
}

void append_tie_rows(Contact& contact, const Carriers& carriers, double dt, std::vector<Row>& rows) {
  const std::size_t first = rows.size();
  const TieScene scene = tie_scene(contact, dt);
  tie_rows(contact.tied.ties, scene, contact.tied.arms, rows);
  append_mortar_ties({contact.tied.mortar, contact.tied.mortar_places, scene.motion, contact.step.nodes.mobility,
                      carriers, scene.recovery, dt},
                     contact.tied.mortar_arms, rows);
  for (Row& row : std::span(rows).subspan(first))
    keep_feasible_rate(row, contact.step.nodes.mobility, contact.step.nodes.motion, carriers);
}

void demand_ties_hold(const Contact& contact, std::span<const Vec3> positions) {
  const TieScene scene = tie_scene(contact, 1);
  const bool torn = are_torn(contact.tied.mortar, contact.tied.mortar_places, positions);
  if (contact.ranks.any(torn ||
                        !std::ranges::all_of(contact.tied.ties, [&](const Tie& tie) { return holds(tie, scene); })))
    throw GuardError("contact: a tie is broken: a face is out of reach of a node tied to it");
}

void drop_tied_rows(const Contact& contact, std::vector<Row>& rows) {
  std::erase_if(rows, [&](const Row& row) {
    if (row.is_wall()) return false;
    if (row.is_edge()) return pairs_of(contact).at(row.slave_block, row.master_block).tied != Tied::no;
    return find_tie(contact.tied.ties, row.key.slave, row.master_body) != nullptr ||
           is_held(contact.tied.mortar, row.key.slave, row.master_body) || nothing_else_acts(contact, row);
  });
}

MortarTies find_mortar_ties(Contact& contact, const std::vector<TiedPair>* pairs) {
  const ContactLists& lists = contact.lists;
  const MortarCandidates candidates = candidates_of(lists, pairs);
  const MortarScene scene{candidates, lists.faces, lists.nodes.gid, contact.step.nodes.motion,
                          *contact.derived.detection.tolerances};
  TieCovers covers = find_tie_covers(scene);
  std::vector<Vec3> sides = tied_sides(scene, covers);
  contact.lists.exchange.share(as_doubles(sides), 3);
  settle_functions(scene, sides, covers);
  MortarTies ties = tie_weights(scene, sides, covers);
  for (MortarTie& row : ties.rows) {
    const auto node = std::ranges::lower_bound(lists.nodes.gid, row.slave) - lists.nodes.gid.begin();
    row.slave_block = tied_block(contact, static_cast<LocalIndex>(node), row.block);
  }
  return ties;
}

void place_mortar_ties(Contact& contact) {
  const std::vector<GlobalIndex>& gid = contact.lists.nodes.gid;
  TiedParts& tied = contact.tied;
  tied.mortar_places.clear();
  for (const GlobalIndex node : tied.mortar.nodes.values) {
    const auto found = std::ranges::lower_bound(gid, node);
    demand(found != gid.end() && *found == node, "nodes of ties are contact nodes");
    tied.mortar_places.push_back(static_cast<LocalIndex>(found - gid.begin()));
  }
  tied.mortar_arms.resize(tied.mortar_places.size());
}

std::vector<GlobalIndex> keys_left(const comm::Communicator& ranks, std::vector<GlobalIndex> keys,
                                   std::span<const mesh::ExteriorFace> faces) {
  const auto count = static_cast<std::size_t>(ranks.size());
  const auto desk_of = [&](GlobalIndex key) { return static_cast<std::size_t>(key) % count; };
  std::vector<std::vector<GlobalIndex>> told(count), asked(count), answers(count);
  sort_unique(keys);
  for (const mesh::ExteriorFace& face : faces) told[desk_of(face.key)].push_back(face.key);
  for (const GlobalIndex key : keys) asked[desk_of(key)].push_back(key);
  std::vector<GlobalIndex> here = comm::exchange(ranks, told).values;
  std::ranges::sort(here);
  const Ragged<GlobalIndex> questions = comm::exchange(ranks, asked);
  for (std::size_t r = 0; r < count; ++r)
    for (const GlobalIndex key : questions.row(static_cast<LocalIndex>(r)))
      if (std::ranges::binary_search(here, key)) answers[r].push_back(key);
  std::vector<GlobalIndex> left = comm::exchange(ranks, answers).values;
  std::ranges::sort(left);
  return left;
}

std::vector<TiedPair> pairs_left(const Contact& contact, std::span<const mesh::ExteriorFace> faces) {
  std::vector<GlobalIndex> keys;
  for (const auto& [facet, face] : contact.tied.pairs_at_start) keys.insert(keys.end(), {facet, face});
  const std::vector<GlobalIndex> left = keys_left(contact.ranks, std::move(keys), faces);
  const auto is_left = [&](GlobalIndex key) { return std::ranges::binary_search(left, key); };
  std::vector<TiedPair> pairs = contact.tied.pairs_at_start;
  std::erase_if(pairs, [&](const TiedPair& pair) { return !is_left(pair.first) || !is_left(pair.second); });
  return pairs;
}

}  // namespace brunt::contact
