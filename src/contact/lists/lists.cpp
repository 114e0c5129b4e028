// SPDX-License-Identifier: Apache-2.0
// Search, then the contact nodes that its result needs, then the links between ranks.
#include "contact/lists/lists.hpp"

#include <algorithm>
#include <utility>

#include "candidate_pairs.hpp"
#include "comm/rendezvous.hpp"
#include "contact/data/tolerances.hpp"
#include "contact/enforcement/system.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"
#include "mortar_pairs.hpp"

namespace brunt::contact {
namespace {

std::vector<WallCandidate> walls_in_reach(const ListBuild& build, std::span<const Wall> walls,
                                          std::span<const char> held) {
  std::vector<WallCandidate> candidates;  // nodes are surface nodes until the table is made
  const std::size_t count = build.surface.gid.size();
  const double reach =
      (build.settings.wall_capture + 2 * build.settings.motion) * (1 + build.settings.tolerances->rounding);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (std::size_t node = 0; node < count; ++node) {
      if (!build.surface.owns(static_cast<LocalIndex>(node), build.ranks.rank())) continue;
      if (!acts_on(walls[w], build.surface.blocks.row(static_cast<LocalIndex>(node)))) continue;
      const bool is_held = held[w * count + node] != 0;
      if (!is_held && (build.positions[node] - walls[w].point).dot(walls[w].normal) > reach) continue;
      candidates.push_back(
          {static_cast<LocalIndex>(node), static_cast<std::int32_t>(w), build.surface.body[node], is_held});
    }
  }
  return candidates;
}

LocalIndex table_index(const NodeTable& table, GlobalIndex gid) {
  const auto found = std::lower_bound(table.gid.begin(), table.gid.end(), gid);
  demand(found != table.gid.end() && *found == gid, "a contact node is missing from the table");
  return static_cast<LocalIndex>(found - table.gid.begin());
}

struct NeededNode {
  GlobalIndex gid = 0;
  Place home;
  friend auto operator<=>(const NeededNode&, const NeededNode&) = default;
};

/// The nodes needed here, and those of this rank that others need.
NodeTable make_table(const ListBuild& build, std::vector<NeededNode> needed, Ragged<LocalIndex>& requested) {
  const Rank here = build.ranks.rank();
  std::vector<std::vector<LocalIndex>> requests(static_cast<std::size_t>(build.ranks.size()));
  sort_unique(needed);
  for (const auto& [gid, home] : needed)
    if (home.rank != here) nth(requests, home.rank).push_back(home.index);
  requested = comm::exchange(build.ranks, requests);
  for (const LocalIndex node : requested.values) needed.push_back({nth(build.surface.gid, node), {here, node}});
  sort_unique(needed);
  NodeTable table;
  for (const auto& [gid, home] : needed) {
    const auto found = std::lower_bound(build.surface.gid.begin(), build.surface.gid.end(), gid);
    const bool known = found != build.surface.gid.end() && *found == gid;
    table.gid.push_back(gid);
    table.home.push_back(home);
    table.surface_node.push_back(known ? static_cast<LocalIndex>(found - build.surface.gid.begin()) : no_index);
  }
  return table;
}

/// Copies and owners exchange the places of the node; both lists of a pair of ranks run in ascending gid.
NodeLinks link_nodes(const ListBuild& build, const NodeTable& table, const Ragged<LocalIndex>& requested) {
  const auto rank_count = static_cast<std::size_t>(build.ranks.size());
  NodeLinks links;
  std::vector<std::vector<LocalIndex>> copy_place(rank_count), owner_place(rank_count);
  for (std::size_t i = 0; i < table.gid.size(); ++i)
    if (table.home[i].rank != build.ranks.rank())
      nth(copy_place, table.home[i].rank).push_back(static_cast<LocalIndex>(i));
  for (Rank r = 0; r < build.ranks.size(); ++r)
    for (const LocalIndex node : requested.row(r))
      nth(owner_place, r).push_back(table_index(table, nth(build.surface.gid, node)));
  const Ragged<LocalIndex> on_copier = comm::exchange(build.ranks, copy_place);
  const Ragged<LocalIndex> on_owner = comm::exchange(build.ranks, owner_place);
  for (Rank r = 0; r < build.ranks.size(); ++r) {
    const auto there = on_owner.row(r), copier = on_copier.row(r);
    for (std::size_t i = 0; i < there.size(); ++i) {
      links.copies.push_back(nth(copy_place, r)[i]);
      links.source.push_back({r, there[i]});
    }
    for (std::size_t i = 0; i < copier.size(); ++i) {
      links.copied.push_back(nth(owner_place, r)[i]);
      links.destination.push_back({r, copier[i]});
    }
  }
  return links;
}

using FacePairs = CandidatePairs<GhostFace>;
using EdgePairs = CandidatePairs<GhostEdge>;

/// Masters that some pair needs, in the order of their first pair: place of each, or no_index.
template <class Ghost>
std::vector<LocalIndex> masters_in_use(const CandidatePairs<Ghost>& found, std::span<const CandidatePair> also,
                                       std::vector<LocalIndex>& used) {
  std::vector<LocalIndex> place(found.masters.size(), no_index);
  for (const std::span<const CandidatePair> pairs : {std::span<const CandidatePair>(found.pairs), also})
    for (const CandidatePair& pair : pairs) {
      LocalIndex& here = nth(place, pair.master);
      if (here != no_index) continue;
      here = static_cast<LocalIndex>(used.size());
      used.push_back(pair.master);
    }
  return place;
}

/// Calls visit(slave, its pairs) in order.
template <class Visit>
void for_each_slave(const std::vector<CandidatePair>& pairs, Visit&& visit) {
  for (std::size_t first = 0, last = 0; first < pairs.size(); first = last) {
    while (last < pairs.size() && pairs[last].slave == pairs[first].slave) ++last;
    visit(pairs[first].slave, std::span(pairs).subspan(first, last - first));
  }
}

/// Facets that have a pair, and those around nodes of kept rows, whose facets they may be.
std::vector<char> facets_in_use(const ListBuild& build, const MortarPairs& mortar) {
  std::vector<char> in_use(mortar.facets.size(), 0);
  for (const CandidatePair& pair : mortar.pairs) nth(in_use, pair.slave) = 1;
  for (std::size_t f = 0; f < in_use.size(); ++f)
    for (std::size_t i = 0; i < static_cast<std::size_t>(mortar.facets[f].corner_count); ++i)
      if (std::ranges::binary_search(build.settings.kept, mortar.facets[f].gid[i])) in_use[f] = 1;
  return in_use;
}

/// place: of masters among lists.faces.
void fill_mortar(const ListBuild& build, const MortarPairs& found, std::span<const LocalIndex> place,
                 ContactLists& lists) {
  MortarCandidates& mortar = lists.mortar;
  const std::vector<char> in_use = facets_in_use(build, found);
  std::vector<std::pair<LocalIndex, LocalIndex>> around;  // slave and facet
  auto pair = found.pairs.begin();
  for (std::size_t f = 0; f < found.facets.size(); ++f) {
    if (in_use[f] == 0) continue;
    const GhostFace& from = found.facets[f];
    MortarFacet facet{.key = from.key, .corner_count = from.corner_count, .body = from.body, .block = from.block};
    facet.element_depth = from.element_depth;
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.corner_count); ++i) {
      facet.nodes[i] = table_index(lists.nodes, from.gid[i]);
      if (from.home[i].rank == build.ranks.rank())
        around.push_back({facet.nodes[i], static_cast<LocalIndex>(mortar.facets.size())});
    }
    mortar.facets.push_back(facet);
    for (; pair != found.pairs.end() && pair->slave == static_cast<LocalIndex>(f); ++pair)
      mortar.masters.values.push_back(nth(place, pair->master));
    mortar.masters.close_row();
  }
  std::ranges::sort(around);
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (i == 0 || around[i].first != around[i - 1].first) {
      if (i > 0) mortar.around.close_row();
      mortar.slave.push_back(around[i].first);
    }
    mortar.around.values.push_back(around[i].second);
  }
  if (!around.empty()) mortar.around.close_row();
  lists.most_rows += mortar.slave.size();
  mortar.any = build.ranks.any(!found.pairs.empty());
}

/// Returns the places of masters among lists.faces, or no_index.
std::vector<LocalIndex> fill_faces(const ListBuild& build, const FacePairs& found, const MortarPairs& mortar,
                                   ContactLists& lists) {
  std::vector<LocalIndex> used;
  std::vector<LocalIndex> place = masters_in_use(found, mortar.pairs, used);
  for (const LocalIndex m : used) {
    const GhostFace& from = nth(found.masters, m);
    MasterFace master{.key = from.key, .corner_count = from.corner_count, .body = from.body, .block = from.block};
    master.element_depth = from.element_depth;
    master.seams = from.seams;
    master.half_thickness = 0.5 * build.settings.thickness_of(from.block);
    master.two_sided = master.half_thickness > 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.corner_count); ++i)
      master.nodes[i] = table_index(lists.nodes, from.gid[i]);
    lists.faces.push_back(master);
  }
  Candidates& candidates = lists.candidates;
  for_each_slave(found.pairs, [&](LocalIndex node, std::span<const CandidatePair> pairs) {
    candidates.slave.push_back(table_index(lists.nodes, nth(build.surface.gid, node)));
    candidates.body.push_back(nth(build.surface.body, node));
    for (const CandidatePair& pair : pairs) candidates.faces.values.push_back(nth(place, pair.master));
    candidates.faces.close_row();
    lists.most_rows += std::min(pairs.size(), most_rows_of_a_node);
    lists.most_faces_of_a_slave = std::max(lists.most_faces_of_a_slave, pairs.size());
  });
  return place;
}

/// Passes of pairs of two bodies; within one that is not known before they meet. Where only the nodes on the master's
/// rims have rows besides those of the slave, the slave keeps all of its own.
void fill_passes(const ListBuild& build, const FacePairs& found, Candidates& candidates) {
  if (!build.settings.two_passes) return;
  const std::vector<BodyFigures>& bodies = build.surface.bodies;
  for (const CandidatePair& pair : found.pairs) {
    SurfaceNode node = build.surface.node(pair.slave);
    const GhostFace& face = nth(found.masters, pair.master);
    const bool primary = is_primary_slave(build.specification, bodies, node, face.block, face.body);
    if (primary) node.on_rim = false;
    const bool two =
        node.body != face.body && meet_in_two_passes(build.specification, bodies, node, face.block, face.body);
    candidates.pass.push_back(!two ? PairPass::only : primary ? PairPass::first : PairPass::second);
  }
}

/// Of the sheets that the slaves lie on; nothing where there are none.
void fill_thickness(const ListBuild& build, const FacePairs& found, Candidates& candidates) {
  if (build.settings.most_clearance() == 0) return;
  for_each_slave(found.pairs, [&](LocalIndex node, auto /*pairs*/) {
    double thickest = 0;
    for (const std::int32_t block : build.surface.blocks.row(node))
      thickest = std::max(thickest, build.settings.thickness_of(block));
    candidates.half_thickness.push_back(0.5 * thickest);
  });
}

/// Which of the facets around slaves go on beyond a seam; nothing where there is none.
void fill_seams(const ListBuild& build, const FacePairs& found, Candidates& candidates) {
  if (build.surface.flush.empty()) return;
  for_each_slave(found.pairs, [&](LocalIndex node, auto /*pairs*/) {
    const auto first = nth(build.surface.facets.offsets, node);
    const auto end = build.surface.facets.offsets[static_cast<std::size_t>(node) + 1];
    candidates.seam_sag.insert(candidates.seam_sag.end(), build.surface.seam_sag.begin() + first,
                               build.surface.seam_sag.begin() + end);
  });
}

/// Facets are left as places until they are numbered.
void fill_edges(const ListBuild& build, const EdgePairs& found, ContactLists& lists, std::vector<Place>& facets) {
  std::vector<LocalIndex> used;
  const std::vector<LocalIndex> place = masters_in_use(found, {}, used);
  EdgeCandidates& edges = lists.edges;
  for (const LocalIndex m : used) {
    const GhostEdge& from = nth(found.masters, m);
    edges.masters.push_back({.nodes = {table_index(lists.nodes, from.gid[0]), table_index(lists.nodes, from.gid[1])},
                             .body = from.body,
                             .block = from.block,
                             .element_depth = from.element_depth,
                             .flat = from.kind == EdgeKind::flat,
                             .seam = from.seam,
                             .end_on_rim = from.end_on_rim,
                             .end_at_side = from.end_at_side});
    facets.insert(facets.end(), from.facets.begin(), from.facets.end());
  }
  for_each_slave(found.pairs, [&](LocalIndex slave, std::span<const CandidatePair> pairs) {
    const SurfaceEdge& from = nth(build.surface.edges, slave);
    const auto contact_node = [&](LocalIndex node) { return table_index(lists.nodes, nth(build.surface.gid, node)); };
    const auto on_rim = [&](LocalIndex node) { return nth(build.surface.on_rim, node); };
    edges.slaves.push_back({.nodes = {contact_node(from.nodes[0]), contact_node(from.nodes[1])},
                            .body = from.body,
                            .block = from.block,
                            .element_depth = from.element_depth,
                            .flat = from.kind == EdgeKind::flat,
                            .seam = from.seam,
                            .end_on_rim = {on_rim(from.nodes[0]), on_rim(from.nodes[1])},
                            .end_at_side = from.end_at_side});
    facets.insert(facets.end(), from.facets.begin(), from.facets.end());
    for (const CandidatePair& pair : pairs) edges.near.values.push_back(nth(place, pair.master));
    edges.near.close_row();
  });
  lists.most_rows += found.pairs.size();
}

/// Where the area vectors of facets come from (those around slaves and wall_nodes, those of edges), and whose are
/// needed.
void link_facets(const ListBuild& build, const FacePairs& found, const std::vector<Place>& of_edges,
                 std::span<const LocalIndex> wall_nodes, ContactLists& lists) {
  std::vector<Place> leaves = of_edges;
  const auto each_slave = [&](auto&& visit) {
    for_each_slave(found.pairs, [&](LocalIndex node, auto /*pairs*/) { visit(build.surface.facets.row(node)); });
  };
  const auto add_leaves = [&](std::span<const Place> facets) {
    leaves.insert(leaves.end(), facets.begin(), facets.end());
  };
  each_slave(add_leaves);
  for (const LocalIndex node : wall_nodes) add_leaves(build.surface.facets.row(node));
  sort_unique(leaves);
  const auto leaf_of = [&](const Place& facet) {
    return static_cast<LocalIndex>(std::lower_bound(leaves.begin(), leaves.end(), facet) - leaves.begin());
  };
  std::vector<comm::RemoteSlot> source;
  std::vector<std::vector<LocalIndex>> needs(static_cast<std::size_t>(build.ranks.size()));
  for (const Place& place : leaves) {
    source.push_back({place.rank, place.index});
    nth(needs, place.rank).push_back(place.index);
  }
  each_slave([&](std::span<const Place> facets) {
    for (const Place& facet : facets) lists.candidates.slave_facets.values.push_back(leaf_of(facet));
    lists.candidates.slave_facets.close_row();
  });
  for (const LocalIndex node : wall_nodes) {
    for (const Place& facet : build.surface.facets.row(node)) lists.wall_facets.values.push_back(leaf_of(facet));
    lists.wall_facets.close_row();
  }
  auto next = of_edges.begin();
  for (std::vector<ContactEdge>* sides : {&lists.edges.masters, &lists.edges.slaves})
    for (ContactEdge& side : *sides)
      for (LocalIndex& facet : side.facets) facet = leaf_of(*next++);
  lists.facet_needed.assign(build.surface.faces.size(), 0);
  for (const LocalIndex face : comm::exchange(build.ranks, needs).values) nth(lists.facet_needed, face) = 1;
  lists.facet_count = static_cast<LocalIndex>(source.size());
  lists.any_facets = build.ranks.any(!source.empty());
  if (lists.any_facets)
    lists.facets = comm::Halo(build.ranks, static_cast<LocalIndex>(build.surface.faces.size()), source);
}

/// Every node that mortar rows have or may have. Collective.
void need_mortar_nodes(const ListBuild& build, const MortarPairs& mortar, std::vector<NeededNode>& needed) {
  if (!build.settings.keeps) return;
  const std::vector<char> in_use = facets_in_use(build, mortar);
  for (std::size_t f = 0; f < mortar.facets.size(); ++f)
    for (std::size_t i = 0; in_use[f] != 0 && i < static_cast<std::size_t>(mortar.facets[f].corner_count); ++i)
      needed.push_back({mortar.facets[f].gid[i], mortar.facets[f].home[i]});
  std::vector<GlobalIndex> kept(build.settings.kept.begin(), build.settings.kept.end());
  kept.insert(kept.end(), build.settings.tied.begin(), build.settings.tied.end());
  sort_unique(kept);
  const std::vector<Place> homes = homes_of(build.ranks, build.surface, kept);
  for (std::size_t i = 0; i < homes.size(); ++i) needed.push_back({kept[i], homes[i]});
}

/// Every node that the pairs name, with its owner; some more than once. Collective.
std::vector<NeededNode> needed_nodes(const ListBuild& build, const FacePairs& faces, const MortarPairs& mortar,
                                     const EdgePairs& edges, const std::vector<WallCandidate>& walls) {
  std::vector<NeededNode> needed;
  need_mortar_nodes(build, mortar, needed);
  const auto need = [&](LocalIndex node) {
    const auto i = static_cast<std::size_t>(node);
    needed.push_back({build.surface.gid[i], build.surface.home[i]});
  };
  for_each_slave(faces.pairs, [&](LocalIndex node, auto /*pairs*/) { need(node); });
  std::vector<LocalIndex> used;
  masters_in_use(faces, mortar.pairs, used);
  for (const LocalIndex m : used) {
    const GhostFace& master = nth(faces.masters, m);
    for (std::size_t i = 0; i < static_cast<std::size_t>(master.corner_count); ++i)
      needed.push_back({master.gid[i], master.home[i]});
  }
  for (const CandidatePair& pair : edges.pairs) {
    for (const LocalIndex node : nth(build.surface.edges, pair.slave).nodes) need(node);
    const GhostEdge& master = nth(edges.masters, pair.master);
    for (std::size_t i = 0; i < 2; ++i) needed.push_back({master.gid[i], master.home[i]});
  }
  for (const WallCandidate& candidate : walls) need(candidate.node);
  return needed;
}

}  // namespace

ContactLists build_lists(const comm::Communicator& ranks, const Surface& surface, const Specification& specification,
                         const Roles& roles, std::span<const Vec3> positions, std::span<const Wall> walls,
                         std::span<const char> held, const ListSettings& settings, ListScratch& scratch) {
  const ListBuild build{ranks, surface, specification, roles, positions, settings, scratch};
  ContactLists lists;
  FacePairs faces;
  MortarPairs mortar;
  EdgePairs edges;
  if (settings.faces) {
    const bool of_facets = settings.facets != FacetPairs::none;
    if (of_facets) mortar.facets = facets_around_slaves(build);
    faces = find_face_pairs(build, capture_boxes(mortar.facets));
    if (of_facets) mortar.pairs = find_mortar_pairs(build, mortar.facets, faces.masters);
    edges = find_edge_pairs(build);
  }
  lists.wall_candidates = walls_in_reach(build, walls, held);

  Ragged<LocalIndex> requested;
  lists.nodes = make_table(build, needed_nodes(build, faces, mortar, edges, lists.wall_candidates), requested);
  std::vector<LocalIndex> wall_nodes;  // in the surface
  for (const WallCandidate& candidate : lists.wall_candidates)
    if (settings.wall_facets) wall_nodes.push_back(candidate.node);
  for (WallCandidate& candidate : lists.wall_candidates)
    candidate.node = table_index(lists.nodes, nth(surface.gid, candidate.node));
  std::vector<Place> edge_facets;
  const std::vector<LocalIndex> place = fill_faces(build, faces, mortar, lists);
  fill_mortar(build, mortar, place, lists);
  fill_passes(build, faces, lists.candidates);
  fill_thickness(build, faces, lists.candidates);
  fill_seams(build, faces, lists.candidates);
  fill_edges(build, edges, lists, edge_facets);
  lists.most_rows += lists.wall_candidates.size() + settings.tied_rows;
  lists.any_rows = ranks.any(lists.most_rows > 0);
  lists.any_edges = ranks.any(!edges.pairs.empty());
  lists.exchange =
      HaloExchange(ranks, static_cast<LocalIndex>(lists.nodes.gid.size()), link_nodes(build, lists.nodes, requested),
                   std::max(node_motion_width + 1, row_sum_width + impulse_width));
  link_facets(build, faces, edge_facets, wall_nodes, lists);
  return lists;
}

}  // namespace brunt::contact
