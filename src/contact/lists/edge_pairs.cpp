// SPDX-License-Identifier: Apache-2.0
// Pairs of edges: rims against all edges, so that flat edges, the most frequent ones, are not searched against each
// other.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "candidate_pairs.hpp"
#include "contact/search/box_overlaps.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

bool is_sharp(EdgeKind kind) {
  return kind == EdgeKind::sharp;
}

Box capture_box(const ListBuild& build, const SurfaceEdge& edge) {
  const std::array ends{build.position(edge.nodes[0]), build.position(edge.nodes[1])};
  return capture_box(build, ends, (ends[1] - ends[0]).norm(), edge.element_depth);
}

/// Boxes of all ranks' edges and rims, as far as they reach, of the bodies that have some.
struct BodyBoxes {
  std::vector<LocalIndex> with_edges, with_rims;
  std::vector<Box> edges, rims;
};

/// Collective.
BodyBoxes boxes_of_bodies(const ListBuild& build) {
  const std::size_t bodies = build.surface.bodies.size();
  std::vector<double> most(12 * bodies, -std::numeric_limits<double>::infinity());
  const auto extend = [&](std::size_t at, const Box& box) {
    for (std::size_t a = 0; a < 3; ++a) {
      most[at + a] = std::max(most[at + a], -box.low[static_cast<Eigen::Index>(a)]);
      most[at + 3 + a] = std::max(most[at + 3 + a], box.high[static_cast<Eigen::Index>(a)]);
    }
  };
  for (const SurfaceEdge& edge : build.surface.edges) {
    const Box box = capture_box(build, edge);
    const std::size_t at = 12 * static_cast<std::size_t>(edge.body);
    extend(at, box);
    if (is_sharp(edge.kind)) extend(at + 6, box);
  }
  build.ranks.max(most);
  BodyBoxes boxes;
  const auto add = [&](std::size_t at, std::size_t body, std::vector<LocalIndex>& bodies_with, std::vector<Box>& list) {
    if (!std::isfinite(most[at])) return;
    bodies_with.push_back(static_cast<LocalIndex>(body));
    list.push_back({-Vec3(&most[at]), Vec3(&most[at + 3])});
  };
  for (std::size_t body = 0; body < bodies; ++body) {
    add(12 * body, body, boxes.with_edges, boxes.edges);
    add(12 * body + 6, body, boxes.with_rims, boxes.rims);
  }
  return boxes;
}

/// This rank's edges but for flat ones that no rim of another body can be near: most are far from all. Where rims are
/// not held (see holds_rims) nothing meets flat ones. Collective.
std::vector<LocalIndex> edges_to_search(const ListBuild& build) {
  const BodyBoxes boxes = holds_rims(build.specification) ? boxes_of_bodies(build) : BodyBoxes{};
  std::vector<std::vector<LocalIndex>> near(build.surface.bodies.size());
  for_each_overlap(boxes.edges, boxes.rims, build.scratch.bodies, [&](LocalIndex one, LocalIndex other) {
    const LocalIndex body = nth(boxes.with_edges, one);
    if (body != nth(boxes.with_rims, other)) nth(near, body).push_back(other);
  });
  std::vector<LocalIndex> chosen;
  for (std::size_t e = 0; e < build.surface.edges.size(); ++e) {
    const SurfaceEdge& edge = build.surface.edges[e];
    const auto is_near = [&](LocalIndex other) {
      return geometry::overlaps(capture_box(build, edge), nth(boxes.rims, other));
    };
    if (edge.kind != EdgeKind::flat || std::ranges::any_of(nth(near, edge.body), is_near))
      chosen.push_back(static_cast<LocalIndex>(e));
  }
  return chosen;
}

/// The sharp ones of these edges, or the others.
std::vector<GhostEdge> own_edges(const ListBuild& build, std::span<const LocalIndex> chosen, bool sharp) {
  std::vector<GhostEdge> edges;
  for (const LocalIndex e : chosen) {
    const SurfaceEdge& edge = nth(build.surface.edges, e);
    if (is_sharp(edge.kind) != sharp) continue;
    GhostEdge master{.facets = edge.facets, .elements = edge.elements, .body = edge.body, .block = edge.block};
    master.element_depth = edge.element_depth;
    master.kind = edge.kind;
    master.seam = edge.seam;
    master.end_at_side = edge.end_at_side;
    for (std::size_t i = 0; i < 2; ++i) {
      master.end_on_rim[i] = nth(build.surface.on_rim, edge.nodes[i]);
      master.gid[i] = nth(build.surface.gid, edge.nodes[i]);
      master.home[i] = nth(build.surface.home, edge.nodes[i]);
    }
    master.capture = PlainBox(capture_box(build, edge));
    edges.push_back(master);
  }
  return edges;
}

/// Slave edges with their boxes.
struct SlaveEdges {
  std::vector<LocalIndex> edge;  ///< of surface.edges
  std::vector<Box> box;
};

/// All of these edges, or the sharp ones alone.
SlaveEdges slave_edges(const ListBuild& build, std::span<const LocalIndex> chosen, bool sharp_alone) {
  SlaveEdges slaves;
  for (const LocalIndex e : chosen) {
    const SurfaceEdge& edge = nth(build.surface.edges, e);
    if (sharp_alone && !is_sharp(edge.kind)) continue;
    slaves.edge.push_back(e);
    slaves.box.push_back(
        geometry::bounding_box(std::array{build.position(edge.nodes[0]), build.position(edge.nodes[1])}));
  }
  return slaves;
}

/// Is a rim of either body held off the other's faces?
bool holds_rims(const ListBuild& build, const SurfaceEdge& slave, const GhostEdge& master) {
  const std::array own{slave.block}, other{master.block};
  const auto rim_may_meet = [&](std::span<const std::int32_t> blocks, std::int32_t body, std::int32_t face_block,
                                std::int32_t face_body) {
    return may_meet(build.specification, build.surface.bodies, {blocks, body, true}, face_block, face_body);
  };
  return rim_may_meet(own, slave.body, master.block, master.body) &&
         rim_may_meet(other, master.body, slave.block, slave.body);
}

/// Once for a pair, however many passes its nodes and faces make. Flat edges meet rims of other bodies; edges of one
/// body meet where their elements do not touch, the lower as slave.
bool is_permitted(const ListBuild& build, const SurfaceEdge& slave, const GhostEdge& master) {
  const std::array block{slave.block};
  if (!is_primary_slave(build.specification, build.surface.bodies, {block, slave.body}, master.block, master.body))
    return false;
  const bool flat = slave.kind == EdgeKind::flat || master.kind == EdgeKind::flat;
  if (slave.body != master.body) return !flat || holds_rims(build, slave, master);
  const std::array gid{nth(build.surface.gid, slave.nodes[0]), nth(build.surface.gid, slave.nodes[1])};
  if (flat || !(gid < master.gid)) return false;
  return std::ranges::none_of(slave.elements, [&](GlobalIndex node) {
    return node != no_index && std::ranges::find(master.elements, node) != master.elements.end();
  });
}

void add_pairs(const ListBuild& build, const SlaveEdges& slaves, std::vector<GhostEdge> masters,
               OverlapScratch& scratch, CandidatePairs<GhostEdge>& result) {
  add_ghosts(build, slaves.box, masters);
  const auto first = static_cast<LocalIndex>(result.masters.size());
  for_each_overlap(slaves.box, capture_boxes(masters), scratch, [&](LocalIndex s, LocalIndex master) {
    const LocalIndex slave = nth(slaves.edge, s);
    if (is_permitted(build, nth(build.surface.edges, slave), nth(masters, master)))
      result.pairs.push_back({slave, first + master});
  });
  result.masters.insert(result.masters.end(), masters.begin(), masters.end());
}

}  // namespace

CandidatePairs<GhostEdge> find_edge_pairs(const ListBuild& build) {
  CandidatePairs<GhostEdge> result;
  const std::vector<LocalIndex> chosen = edges_to_search(build);
  add_pairs(build, slave_edges(build, chosen, false), own_edges(build, chosen, true), build.scratch.rims, result);
  add_pairs(build, slave_edges(build, chosen, true), own_edges(build, chosen, false), build.scratch.edges, result);
  std::sort(result.pairs.begin(), result.pairs.end(), [&](const CandidatePair& a, const CandidatePair& b) {
    if (a.slave != b.slave) return a.slave < b.slave;
    return nth(result.masters, a.master).gid < nth(result.masters, b.master).gid;
  });
  return result;
}

}  // namespace brunt::contact
