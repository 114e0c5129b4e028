// SPDX-License-Identifier: Apache-2.0
// Search, then the contact nodes that its result needs, then the links between ranks.
#include "brunt/contact/lists.hpp"

#include <algorithm>
#include <utility>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/contact/ghosting.hpp"
#include "brunt/contact/search/search.hpp"
#include "brunt/core/error.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

struct Build {
  const comm::Communicator& ranks;
  const Surface& surface;
  const PairTable& pairs;
  const Roles& roles;
  std::span<const Vec3> positions;
  const ListSettings& settings;
};

/// This rank's surface faces as masters. The capture box holds everything within the detection's reach even after
/// node and face have moved towards each other by the motion allowed (which may stretch an edge by twice that).
std::vector<TravellingFace> own_masters(const Build& build) {
  std::vector<TravellingFace> masters;
  for (const SurfaceFace& face : build.surface.faces) {
    if (build.roles.master[static_cast<std::size_t>(face.body)] == 0) continue;
    TravellingFace master{.key = face.key, .corner_count = face.corner_count, .body = face.body, .block = face.block};
    master.depth = face.depth;
    const auto count = static_cast<std::size_t>(face.corner_count);
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < count; ++i) {
      const auto node = static_cast<std::size_t>(face.nodes[i]);
      corners[i] = build.positions[node];
      master.gid[i] = build.surface.gid[node];
      master.home[i] = build.surface.home[node];
    }
    const double edge = geometry::longest_edge({corners.data(), count});
    const double motion = build.settings.motion;
    const double reach = build.settings.capture * (edge + 2 * motion) + 2 * motion;
    // the criterion of detection is evaluated later and rounds otherwise
    const geometry::Box box = geometry::grown(geometry::bounding_box({corners.data(), count}), reach * (1 + 1e-6));
    for (std::size_t a = 0; a < 3; ++a) {
      master.low[a] = box.low[static_cast<int>(a)];
      master.high[a] = box.high[static_cast<int>(a)];
    }
    masters.push_back(master);
  }
  return masters;
}

struct Slaves {
  std::vector<LocalIndex> surface_node;
  std::vector<Vec3> position;
};

Slaves own_slaves(const Build& build) {
  Slaves slaves;
  for (LocalIndex node = 0; node < static_cast<LocalIndex>(build.surface.gid.size()); ++node) {
    if (!build.surface.owns(node, build.ranks.rank()) || build.surface.blocks.row(node).empty()) continue;
    if (build.roles.slave[static_cast<std::size_t>(build.surface.body[static_cast<std::size_t>(node)])] == 0) continue;
    slaves.surface_node.push_back(node);
    slaves.position.push_back(build.positions[static_cast<std::size_t>(node)]);
  }
  return slaves;
}

struct Pair {
  LocalIndex slave = 0;  ///< surface node
  LocalIndex face = 0;   ///< into the masters
};

/// Permitted pairs by slave, master body, key.
std::vector<Pair> search_pairs(const Build& build, const Slaves& slaves, const std::vector<TravellingFace>& masters) {
  std::vector<geometry::Box> boxes;
  boxes.reserve(masters.size());
  for (const TravellingFace& master : masters) boxes.push_back(master.box());
  SearchScratch scratch;
  Ragged<LocalIndex> found;
  find_pairs(boxes, slaves.position, scratch, found);
  std::vector<Pair> pairs;
  for (LocalIndex s = 0; s < found.rows(); ++s) {
    const LocalIndex node = slaves.surface_node[static_cast<std::size_t>(s)];
    for (const LocalIndex f : std::as_const(found).row(s)) {
      const TravellingFace& master = masters[static_cast<std::size_t>(f)];
      if (may_meet(build.pairs, build.surface.bodies, build.surface.blocks.row(node),
                   build.surface.body[static_cast<std::size_t>(node)], master.block, master.body))
        pairs.push_back({node, f});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) {
    if (a.slave != b.slave) return a.slave < b.slave;
    const TravellingFace &one = masters[static_cast<std::size_t>(a.face)],
                         &other = masters[static_cast<std::size_t>(b.face)];
    return one.body != other.body ? one.body < other.body : one.key < other.key;
  });
  return pairs;
}

std::vector<WallCandidate> walls_in_reach(const Build& build, std::span<const Wall> walls, std::span<const char> held) {
  std::vector<WallCandidate> candidates;  // nodes are surface nodes until the table is made
  const std::size_t count = build.surface.gid.size();
  const double reach = (build.settings.wall_capture + 2 * build.settings.motion) * (1 + 1e-6);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (std::size_t node = 0; node < count; ++node) {
      if (!build.surface.owns(static_cast<LocalIndex>(node), build.ranks.rank())) continue;
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

template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The nodes needed here, and those of this rank that others need.
NodeTable make_table(const Build& build, std::vector<NeededNode> needed, Ragged<LocalIndex>& requested) {
  const Rank here = build.ranks.rank();
  std::vector<std::vector<LocalIndex>> requests(static_cast<std::size_t>(build.ranks.size()));
  sort_unique(needed);
  for (const auto& [gid, home] : needed)
    if (home.rank != here) requests[static_cast<std::size_t>(home.rank)].push_back(home.index);
  requested = comm::exchange(build.ranks, requests);
  for (const LocalIndex node : requested.values)
    needed.push_back({build.surface.gid[static_cast<std::size_t>(node)], {here, node}});
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

/// Copies and owners tell each other where they keep the node; both lists of a pair of ranks run in ascending gid.
NodeLinks link_nodes(const Build& build, const NodeTable& table, const Ragged<LocalIndex>& requested) {
  const auto rank_count = static_cast<std::size_t>(build.ranks.size());
  NodeLinks links;
  std::vector<std::vector<LocalIndex>> copy_place(rank_count), owner_place(rank_count);
  for (std::size_t i = 0; i < table.gid.size(); ++i)
    if (table.home[i].rank != build.ranks.rank())
      copy_place[static_cast<std::size_t>(table.home[i].rank)].push_back(static_cast<LocalIndex>(i));
  for (Rank r = 0; r < build.ranks.size(); ++r)
    for (const LocalIndex node : requested.row(r))
      owner_place[static_cast<std::size_t>(r)].push_back(
          table_index(table, build.surface.gid[static_cast<std::size_t>(node)]));
  const Ragged<LocalIndex> on_copier = comm::exchange(build.ranks, copy_place);
  const Ragged<LocalIndex> on_owner = comm::exchange(build.ranks, owner_place);
  for (Rank r = 0; r < build.ranks.size(); ++r) {
    const auto there = on_owner.row(r), copier = on_copier.row(r);
    for (std::size_t i = 0; i < there.size(); ++i) {
      links.copies.push_back(copy_place[static_cast<std::size_t>(r)][i]);
      links.source.push_back({r, there[i]});
    }
    for (std::size_t i = 0; i < copier.size(); ++i) {
      links.copied.push_back(owner_place[static_cast<std::size_t>(r)][i]);
      links.destination.push_back({r, copier[i]});
    }
  }
  return links;
}

void fill_candidates(const Build& build, const std::vector<Pair>& pairs, const std::vector<TravellingFace>& masters,
                     ContactLists& lists) {
  std::vector<LocalIndex> face_here(masters.size(), no_index);
  for (const Pair& pair : pairs) {
    LocalIndex& face = face_here[static_cast<std::size_t>(pair.face)];
    if (face != no_index) continue;
    face = static_cast<LocalIndex>(lists.faces.size());
    const TravellingFace& from = masters[static_cast<std::size_t>(pair.face)];
    MasterFace master{.key = from.key, .corner_count = from.corner_count, .body = from.body, .block = from.block};
    master.depth = from.depth;
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.corner_count); ++i)
      master.nodes[i] = table_index(lists.nodes, from.gid[i]);
    lists.faces.push_back(master);
  }
  Candidates& candidates = lists.candidates;
  for (std::size_t i = 0; i < pairs.size();) {
    const LocalIndex node = pairs[i].slave;
    const std::size_t before = candidates.faces.values.size();
    candidates.slave.push_back(table_index(lists.nodes, build.surface.gid[static_cast<std::size_t>(node)]));
    candidates.body.push_back(build.surface.body[static_cast<std::size_t>(node)]);
    std::int32_t last_body = no_index;
    for (; i < pairs.size() && pairs[i].slave == node; ++i) {
      const LocalIndex face = face_here[static_cast<std::size_t>(pairs[i].face)];
      candidates.faces.values.push_back(face);
      const std::int32_t body = lists.faces[static_cast<std::size_t>(face)].body;
      if (body != last_body) ++lists.most_rows;
      last_body = body;
    }
    candidates.faces.close_row();
    lists.most_faces_of_a_slave = std::max(lists.most_faces_of_a_slave, candidates.faces.values.size() - before);
  }
}

/// Where the area vectors of the slaves' own faces come from, and whose are needed.
void link_facets(const Build& build, const std::vector<Pair>& pairs, ContactLists& lists) {
  std::vector<Place> leaves;
  const auto each_slave = [&](auto&& visit) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (i == 0 || pairs[i].slave != pairs[i - 1].slave) visit(build.surface.facets.row(pairs[i].slave));
  };
  each_slave([&](std::span<const Place> facets) { leaves.insert(leaves.end(), facets.begin(), facets.end()); });
  sort_unique(leaves);
  std::vector<comm::RemoteSlot> source;
  std::vector<std::vector<LocalIndex>> needs(static_cast<std::size_t>(build.ranks.size()));
  for (const Place& place : leaves) {
    source.push_back({place.rank, place.index});
    needs[static_cast<std::size_t>(place.rank)].push_back(place.index);
  }
  each_slave([&](std::span<const Place> facets) {
    for (const Place& facet : facets) {
      const auto leaf = std::lower_bound(leaves.begin(), leaves.end(), facet);
      lists.candidates.slave_facets.values.push_back(static_cast<LocalIndex>(leaf - leaves.begin()));
    }
    lists.candidates.slave_facets.close_row();
  });
  lists.facet_needed.assign(build.surface.faces.size(), 0);
  for (const LocalIndex face : comm::exchange(build.ranks, needs).values)
    lists.facet_needed[static_cast<std::size_t>(face)] = 1;
  lists.facet_count = static_cast<LocalIndex>(source.size());
  lists.any_facets = build.ranks.any(!source.empty());
  if (lists.any_facets)
    lists.facets = comm::Halo(build.ranks, static_cast<LocalIndex>(build.surface.faces.size()), source);
}

/// Slaves and wall candidates, and the corners of the faces; some more than once.
std::vector<NeededNode> needed_nodes(const Build& build, const std::vector<Pair>& pairs,
                                     const std::vector<TravellingFace>& masters,
                                     std::span<const WallCandidate> wall_candidates) {
  std::vector<NeededNode> needed;
  const auto need = [&](LocalIndex node) {
    const auto i = static_cast<std::size_t>(node);
    needed.push_back({build.surface.gid[i], build.surface.home[i]});
  };
  std::vector<char> has_corners(masters.size(), 0);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (p == 0 || pairs[p].slave != pairs[p - 1].slave) need(pairs[p].slave);
    const auto f = static_cast<std::size_t>(pairs[p].face);
    if (std::exchange(has_corners[f], 1) != 0) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(masters[f].corner_count); ++i)
      needed.push_back({masters[f].gid[i], masters[f].home[i]});
  }
  for (const WallCandidate& candidate : wall_candidates) need(candidate.node);
  return needed;
}

}  // namespace

ContactLists build_lists(const comm::Communicator& ranks, const Surface& surface, const PairTable& pairs,
                         const Roles& roles, std::span<const Vec3> positions, std::span<const Wall> walls,
                         std::span<const char> held, const ListSettings& settings) {
  const Build build{ranks, surface, pairs, roles, positions, settings};
  ContactLists lists;
  std::vector<TravellingFace> masters;
  std::vector<Pair> found;
  if (settings.faces) {
    const Slaves slaves = own_slaves(build);
    masters = own_masters(build);
    const std::vector<TravellingFace> ghosts =
        ghost_faces(ranks, masters, slaves.position, 2 * (surface.mean_edge + 2 * settings.motion));
    masters.insert(masters.end(), ghosts.begin(), ghosts.end());
    found = search_pairs(build, slaves, masters);
  }
  lists.wall_candidates = walls_in_reach(build, walls, held);

  Ragged<LocalIndex> requested;
  lists.nodes = make_table(build, needed_nodes(build, found, masters, lists.wall_candidates), requested);
  for (WallCandidate& candidate : lists.wall_candidates)
    candidate.node = table_index(lists.nodes, surface.gid[static_cast<std::size_t>(candidate.node)]);
  fill_candidates(build, found, masters, lists);
  lists.most_rows += lists.wall_candidates.size();
  lists.any_rows = ranks.any(lists.most_rows > 0);
  lists.exchange = HaloExchange(ranks, static_cast<LocalIndex>(lists.nodes.gid.size()),
                                link_nodes(build, lists.nodes, requested), node_motion_width + 1);
  link_facets(build, found, lists);
  return lists;
}

}  // namespace brunt::contact
