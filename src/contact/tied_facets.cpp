// SPDX-License-Identifier: Apache-2.0
#include "tied_facets.hpp"

#include <algorithm>

#include "comm/rendezvous.hpp"
#include "contact/mortar_rows/tie_weights.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"
#include "memory.hpp"
#include "slave.hpp"
#include "tied_parts.hpp"

namespace brunt::contact {
namespace {

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
