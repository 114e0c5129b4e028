// SPDX-License-Identifier: Apache-2.0
#include "mortar_pairs.hpp"

#include <algorithm>
#include <utility>

#include "comm/rendezvous.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"

namespace brunt::contact {
namespace {

/// Of two faces of different bodies, the first one's the slave.
bool may_share_segments(const ListBuild& build, const GhostFace& slave, const GhostFace& master) {
  if (slave.body == master.body) return false;
  const PairSpecification& pair = build.specification.pairs.at(slave.block, master.block);
  const bool wanted = build.settings.facets == FacetPairs::tied ? pair.tied != Tied::no : pair.passes == Passes::mortar;
  if (pair.rule == PairRule::apart || !wanted) return false;
  if (pair.rule == PairRule::automatic)
    return is_slave(build.surface.bodies, slave.body, master.body, *build.settings.tolerances);
  return pair.rule == PairRule::slave;
}

GhostFace facet_of(const ListBuild& build, const SurfaceFace& face) {
  GhostFace facet{.key = face.key,
                  .corner_count = face.corner_count,
                  .body = face.body,
                  .block = face.block,
                  .element_depth = face.element_depth};
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    corners[i] = build.position(face.nodes[i]);
    facet.gid[i] = nth(build.surface.gid, face.nodes[i]);
    facet.home[i] = nth(build.surface.home, face.nodes[i]);
  }
  facet.capture = PlainBox(geometry::bounding_box(std::span(corners).first(count)));
  return facet;
}

}  // namespace

std::vector<GhostFace> facets_around_slaves(const ListBuild& build) {
  const auto count = static_cast<std::size_t>(build.ranks.size());
  std::vector<std::vector<LocalIndex>> asked(count);
  for (LocalIndex node = 0; node < static_cast<LocalIndex>(build.surface.gid.size()); ++node) {
    if (!build.surface.owns(node, build.ranks.rank()) || build.surface.blocks.row(node).empty()) continue;
    if (nth(build.roles.slave, nth(build.surface.body, node)) == 0) continue;
    for (const Place& place : build.surface.facets.row(node)) nth(asked, place.rank).push_back(place.index);
  }
  for (std::vector<LocalIndex>& of_rank : asked) sort_unique(of_rank);
  const Ragged<LocalIndex> wanted = comm::exchange(build.ranks, asked);
  std::vector<std::vector<GhostFace>> answers(count);
  for (std::size_t r = 0; r < count; ++r)
    for (const LocalIndex face : wanted.row(static_cast<LocalIndex>(r)))
      answers[r].push_back(facet_of(build, nth(build.surface.faces, face)));
  std::vector<GhostFace> facets = comm::exchange(build.ranks, answers).values;
  std::sort(facets.begin(), facets.end());
  return facets;
}

std::vector<CandidatePair> find_mortar_pairs(const ListBuild& build, std::span<const GhostFace> facets,
                                             std::span<const GhostFace> masters) {
  std::vector<geometry::Box> slave_boxes, master_boxes;
  for (const GhostFace& facet : facets) slave_boxes.push_back(facet.capture.box());
  for (const GhostFace& master : masters) master_boxes.push_back(master.capture.box());
  std::vector<CandidatePair> pairs;
  for_each_overlap(slave_boxes, master_boxes, build.scratch.facets, [&](LocalIndex facet, LocalIndex master) {
    if (may_share_segments(build, nth(facets, facet), nth(masters, master))) pairs.push_back({facet, master});
  });
  std::ranges::sort(pairs, [&](const CandidatePair& a, const CandidatePair& b) {
    if (a.slave != b.slave) return a.slave < b.slave;
    const GhostFace &one = nth(masters, a.master), &other = nth(masters, b.master);
    return std::pair(one.body, one.key) < std::pair(other.body, other.key);
  });
  return pairs;
}

std::vector<Place> homes_of(const comm::Communicator& ranks, const Surface& surface,
                            std::span<const GlobalIndex> gids) {
  struct Known {
    GlobalIndex gid = 0;
    Place home;
  };
  const auto count = static_cast<std::size_t>(ranks.size());
  const auto desk_of = [&](GlobalIndex gid) { return static_cast<std::size_t>(gid) % count; };
  std::vector<std::vector<Known>> told(count);
  std::vector<std::vector<GlobalIndex>> asked(count);
  for (std::size_t i = 0; i < surface.gid.size(); ++i)
    if (surface.home[i].rank == ranks.rank())
      told[desk_of(surface.gid[i])].push_back({surface.gid[i], surface.home[i]});
  for (const GlobalIndex gid : gids) asked[desk_of(gid)].push_back(gid);
  std::vector<Known> here = comm::exchange(ranks, told).values;
  std::ranges::sort(here, {}, &Known::gid);
  const Ragged<GlobalIndex> questions = comm::exchange(ranks, asked);
  std::vector<std::vector<Known>> answers(count);
  for (std::size_t r = 0; r < count; ++r)
    for (const GlobalIndex gid : questions.row(static_cast<LocalIndex>(r))) {
      const auto found = std::ranges::lower_bound(here, gid, {}, &Known::gid);
      demand(found != here.end() && found->gid == gid, "a node of a mortar row is on the surface");
      answers[r].push_back(*found);
    }
  std::vector<Known> known = comm::exchange(ranks, answers).values;
  std::ranges::sort(known, {}, &Known::gid);
  std::vector<Place> homes;
  for (const Known& node : known) homes.push_back(node.home);
  return homes;
}

}  // namespace brunt::contact
