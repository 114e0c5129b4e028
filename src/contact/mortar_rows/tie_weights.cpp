// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar_rows/tie_weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "contact/data/tolerances.hpp"
#include "core/sorted.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

/// One row while it is made.
struct Draft {
  std::int32_t body = 0, block = std::numeric_limits<std::int32_t>::max();
  Vec3 normal = Vec3::Zero();
  double area = 0, size = 0;
  std::vector<LocalIndex> points;  ///< contact nodes
  std::vector<double> weights;     ///< times the area
  std::vector<char> of_master;
  double nearest = std::numeric_limits<double>::infinity();  ///< face to the node [length]
  std::array<LocalIndex, 4> below{no_index, no_index, no_index,
                                  no_index};  ///< nodes with a weight at its nearest point
  struct Facet {
    LocalIndex facet = 0;
    double share = 0, moment = 0;  ///< moment: of the gap along the normal [length^3]
  };
  std::vector<Facet> facets;

  void add(LocalIndex point, bool master, double weight) {
    std::size_t i = 0;
    while (i < points.size() && !(points[i] == point && (of_master[i] != 0) == master)) ++i;
    if (i == points.size()) {
      points.push_back(point);
      weights.push_back(0);
      of_master.push_back(master ? 1 : 0);
    }
    weights[i] += weight;
  }
};

Draft& draft_of(const TieCover& cover, const Vec3& side, double facing, std::vector<Draft>& drafts) {
  for (Draft& draft : drafts)
    if (draft.body == cover.body && draft.normal.dot(cover.normal) >= facing) return draft;
  drafts.emplace_back();
  drafts.back().body = cover.body;
  drafts.back().normal = side.dot(cover.normal) >= facing ? side : cover.normal;
  return drafts.back();
}

/// The nodes of the face that are the place below this one, if it is the nearest of the row's.
void look_below(const MortarScene& scene, const MasterFace& face, const Vec3& place, Draft& draft) {
  constexpr double none = 1e-6;  // above the rounding of coordinates in single precision
  const CornersNow corners(face, scene.motion);
  const auto closest = geometry::closest_point(place, corners.span());
  if (!closest) return;
  const Vec3 offset = place - closest->point, normal = geometry::area_vector(corners.span()).normalized();
  const double across = (offset - normal.dot(offset) * normal).norm();
  if (across > scene.tolerances.rim * geometry::longest_edge(corners.span()) || !(offset.norm() < draft.nearest))
    return;
  draft.nearest = offset.norm();
  for (std::size_t c = 0; c < 4; ++c)
    draft.below[c] = c < corners.count && closest->weights[c] > none ? face.nodes[c] : no_index;
}

void add_cover(const MortarScene& scene, const TieCovers& covers, const TieCover& cover, std::size_t j, Draft& draft) {
  const MortarFacet& slave = nth(scene.candidates.facets, cover.facet);
  const CornersNow corners(slave, scene.motion);
  const Vec3& origin = corners.point[0];
  double moment = 0;
  draft.area += cover.share[j];
  draft.block = std::min(draft.block, cover.block);
  draft.size = std::max(draft.size, geometry::longest_edge(corners.span()));
  for (std::size_t k = 0; k < corners.count; ++k) {
    draft.add(slave.nodes[k], false, cover.own[j][k]);
    moment += cover.own[j][k] * cover.normal.dot(corners.point[k] - origin);
  }
  for (const TieSegment& segment : covers.segments_of(cover)) {
    const MasterFace& master = nth(scene.faces, segment.face);
    for (std::size_t c = 0; c < static_cast<std::size_t>(master.corner_count); ++c) {
      const double weight = segment.weight[j][c];
      draft.add(master.nodes[c], true, -weight);
      moment -= weight * cover.normal.dot(nth(scene.motion, master.nodes[c]).position - origin);
    }
    look_below(scene, master, corners.point[j], draft);
  }
  draft.facets.push_back({cover.facet, cover.share[j], moment});
}

/// The node itself, the master's by gid, other slaves likewise, those without weight last.
std::vector<std::size_t> order_of(const MortarScene& scene, LocalIndex node, const Draft& draft) {
  std::vector<std::size_t> order(draft.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) {
    const int part = draft.of_master[i] != 0 ? 1 : draft.points[i] == node ? 0 : draft.weights[i] != 0 ? 2 : 3;
    return std::tuple(part, nth(scene.gid, draft.points[i]));
  });
  return order;
}

void append_facets(const MortarScene& scene, const Draft& draft, std::span<const std::size_t> order, MortarTie& row,
                   MortarTies& ties) {
  const auto term_of = [&](LocalIndex point) {
    const auto found =
        std::ranges::find_if(order, [&](std::size_t i) { return draft.points[i] == point && draft.of_master[i] == 0; });
    return static_cast<std::int32_t>(found - order.begin());
  };
  for (const Draft::Facet& from : draft.facets) {
    const MortarFacet& slave = nth(scene.candidates.facets, from.facet);
    TiedFacet facet{.corner_count = slave.corner_count, .share = from.share / draft.area};
    for (std::size_t i = 0; i < static_cast<std::size_t>(slave.corner_count); ++i)
      facet.corner[i] = term_of(slave.nodes[i]);
    const double height = from.moment / draft.area;  // one that is rounding has no moment
    if (std::abs(height) > scene.tolerances.fine_rounding * draft.size) facet.height = height;
    row.apart = row.apart || facet.height != 0;
    ties.facets.values.push_back(facet);
  }
  ties.facets.close_row();
}

void append_row(const MortarScene& scene, LocalIndex node, std::int32_t number, const Draft& draft, MortarTies& ties) {
  MortarTie row{.slave = nth(scene.gid, node),
                .body = draft.body,
                .number = number,
                .slave_body = nth(scene.candidates.facets, draft.facets.front().facet).body,
                .block = draft.block,
                .area = draft.area,
                .size = draft.size};
  const std::vector<std::size_t> order = order_of(scene, node, draft);
  for (const std::size_t i : order) {
    ties.nodes.values.push_back(nth(scene.gid, draft.points[i]));
    ties.weights.push_back(draft.weights[i] / draft.area);
    if (draft.of_master[i] != 0 || draft.points[i] == node || draft.weights[i] != 0) ++row.weighted;
  }
  ties.nodes.close_row();
  for (std::size_t c = 0; c < 4; ++c) {
    if (draft.below[c] == no_index) continue;
    const auto term = std::ranges::find_if(
        order, [&](std::size_t i) { return draft.points[i] == draft.below[c] && draft.of_master[i] != 0; });
    row.below[c] = static_cast<std::int32_t>(term - order.begin());
  }
  append_facets(scene, draft, order, row, ties);
  ties.rows.push_back(row);
}

void append_node(const MortarScene& scene, std::span<const Vec3> sides, const TieCovers& covers, std::size_t s,
                 std::vector<Draft>& drafts, MortarTies& ties) {
  const LocalIndex node = scene.candidates.slave[s];
  drafts.clear();
  for (const LocalIndex facet : scene.candidates.around.row(static_cast<LocalIndex>(s))) {
    const auto& nodes = nth(scene.candidates.facets, facet).nodes;
    const auto j = static_cast<std::size_t>(std::ranges::find(nodes, node) - nodes.begin());
    for (const TieCover& cover : covers.of(facet)) {
      ties.held.push_back({nth(scene.gid, node), cover.body});
      if (cover.share[j] > 0)
        add_cover(scene, covers, cover, j, draft_of(cover, nth(sides, node), scene.tolerances.facing, drafts));
    }
  }
  std::ranges::stable_sort(drafts, {}, &Draft::body);
  std::int32_t number = 0;
  for (std::size_t d = 0; d < drafts.size(); ++d) {
    number = d > 0 && drafts[d].body == drafts[d - 1].body ? number + 1 : 0;
    append_row(scene, node, number, drafts[d], ties);
  }
}

}  // namespace

MortarTies tie_weights(const MortarScene& scene, std::span<const Vec3> sides, const TieCovers& covers) {
  MortarTies ties;
  std::vector<Draft> drafts;
  for (std::size_t s = 0; s < scene.candidates.slave.size(); ++s) append_node(scene, sides, covers, s, drafts, ties);
  for (const TieCover& cover : covers.covers)
    for (const TieSegment& segment : covers.segments_of(cover))
      ties.pairs.push_back({nth(scene.candidates.facets, cover.facet).key, nth(scene.faces, segment.face).key});
  sort_unique(ties.held);
  sort_unique(ties.pairs);
  return ties;
}

}  // namespace brunt::contact
