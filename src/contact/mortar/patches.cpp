// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/patches.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "contact/mortar/corners.hpp"
#include "core/cells.hpp"
#include "core/sorted.hpp"
#include "core/union_find.hpp"

namespace brunt::contact {

namespace {

constexpr std::size_t corners_a_facet = 4;

/// One side of an edge: a facet, and the corner at which the edge begins.
struct EdgeSide {
  LocalIndex low = no_index, high = no_index;  ///< nodes
  std::size_t facet = 0, first = 0, second = 0;
};

std::vector<EdgeSide> edge_sides(std::span<const FacetNodes> facets) {
  std::vector<EdgeSide> sides;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const std::size_t n = cells::corner_count(facets[f]);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      const auto [low, high] = std::minmax(facets[f][k], facets[f][next]);
      sides.push_back({low, high, f, k, next});
    }
  }
  std::ranges::sort(sides, {}, [](const EdgeSide& side) { return std::tuple(side.low, side.high, side.facet); });
  return sides;
}

/// Unit normals; zero for facets without area.
std::vector<Vec3> normals_of(std::span<const FacetNodes> facets, std::span<const Vec3> x) {
  std::vector<Vec3> normals;
  SlavePlane plane;
  for (const FacetNodes& facet : facets)
    normals.push_back(make_slave_plane(CornersOf(facet, x).span(), plane) ? plane.normal : Vec3(Vec3::Zero()));
  return normals;
}

/// A facet without area has no normal, and no sharp edge.
bool is_sharp(const Vec3& normal, const Vec3& other) {
  return !normal.isZero(0) && !other.isZero(0) && normal.dot(other) <= smooth;
}

/// Calls visit(side, other side) for neighbours at each edge.
template <class Visit>
void for_neighbours(const std::vector<EdgeSide>& sides, const Visit& visit) {
  for (std::size_t k = 0; k + 1 < sides.size(); ++k)
    if (sides[k].low == sides[k + 1].low && sides[k].high == sides[k + 1].high) visit(sides[k], sides[k + 1]);
}

/// Whether the edge is sharp and convex.
bool is_ridge(std::span<const FacetNodes> facets, const std::vector<Vec3>& normals, std::span<const Vec3> x,
              const EdgeSide& a, const EdgeSide& b) {
  if (!is_sharp(normals[a.facet], normals[b.facet])) return false;
  const FacetNodes& nodes = facets[a.facet];
  const Vec3 along = nth(x, nodes[a.second]) - nth(x, nodes[a.first]);
  return normals[a.facet].cross(normals[b.facet]).dot(along) > 0;
}

}  // namespace

PatchRows patch_rows(std::span<const FacetNodes> facets, std::span<const Vec3> reference) {
  const std::vector<Vec3> normals = normals_of(facets, reference);
  UnionFind joined(corners_a_facet * facets.size());
  for_neighbours(edge_sides(facets), [&](const EdgeSide& a, const EdgeSide& b) {
    if (is_sharp(normals[a.facet], normals[b.facet])) return;
    const bool same = facets[a.facet][a.first] == facets[b.facet][b.first];
    joined.join(corners_a_facet * a.facet + a.first, corners_a_facet * b.facet + (same ? b.first : b.second));
    joined.join(corners_a_facet * a.facet + a.second, corners_a_facet * b.facet + (same ? b.second : b.first));
  });
  std::vector<std::pair<LocalIndex, std::size_t>> rows;  // node, first corner of the patch
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t k = 0; k < corners_a_facet; ++k)
      if (facets[f][k] != no_index) rows.emplace_back(facets[f][k], joined.first(corners_a_facet * f + k));
  std::vector<std::pair<LocalIndex, std::size_t>> each = rows;
  sort_unique(each);
  PatchRows out;
  for (const auto& [node, first] : each) out.nodes.push_back(node);
  auto next = rows.begin();
  for (const FacetNodes& facet : facets) {
    FacetNodes& of_corner = out.of_corner.emplace_back();
    for (std::size_t k = 0; k < corners_a_facet; ++k)
      of_corner[k] = facet[k] == no_index
                         ? no_index
                         : static_cast<LocalIndex>(std::ranges::lower_bound(each, *next++) - each.begin());
  }
  return out;
}

std::vector<std::size_t> region_colours(std::span<const FacetNodes> facets, std::span<const Vec3> reference) {
  const std::vector<Vec3> normals = normals_of(facets, reference);
  UnionFind joined(facets.size());
  for_neighbours(edge_sides(facets), [&](const EdgeSide& a, const EdgeSide& b) {
    if (!is_sharp(normals[a.facet], normals[b.facet])) joined.join(a.facet, b.facet);
  });
  std::map<LocalIndex, std::set<std::size_t>> at_node;
  std::map<std::size_t, std::set<LocalIndex>> nodes_of;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const LocalIndex node : facets[f]) {
      if (node == no_index) continue;
      at_node[node].insert(joined.first(f));
      nodes_of[joined.first(f)].insert(node);
    }
  std::map<std::size_t, std::size_t> colour;  // of a region, by its first facet
  for (const auto& [region, nodes] : nodes_of) {
    std::set<std::size_t> taken;
    for (const LocalIndex node : nodes)
      for (const std::size_t other : at_node[node])
        if (const auto known = colour.find(other); known != colour.end()) taken.insert(known->second);
    std::size_t free = 0;
    while (taken.contains(free)) ++free;
    colour[region] = free;
  }
  std::vector<std::size_t> colours;
  for (std::size_t f = 0; f < facets.size(); ++f) colours.push_back(colour[joined.first(f)]);
  return colours;
}

NodePatches patches_of(std::span<const PatchNumbers> facets) {
  std::vector<GlobalIndex> each;
  for (const PatchNumbers& facet : facets)
    for (const GlobalIndex number : facet.of_corner)
      if (number >= 0) each.push_back(number);
  sort_unique(each);
  NodePatches patches;
  Ragged<LocalIndex> of_facets;
  for (const PatchNumbers& facet : facets) {
    FacetNodes& of_corner = patches.of_corner.emplace_back();
    patches.rims.push_back(static_cast<std::uint8_t>(facet.rims));
    for (std::size_t k = 0; k < of_corner.size(); ++k) {
      const GlobalIndex number = facet.of_corner[k];
      of_corner[k] =
          number < 0 ? no_index : static_cast<LocalIndex>(std::ranges::lower_bound(each, number) - each.begin());
      if (number >= 0) of_facets.values.push_back(of_corner[k]);
    }
    of_facets.close_row();
  }
  transpose(of_facets, each.size(), patches.facets);
  patches.at_rim.assign(each.size(), 0);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const FacetNodes& of_corner = patches.of_corner[f];
    const std::size_t corners = cells::corner_count(of_corner);
    for (std::size_t k = 0; k < corners; ++k)
      if ((patches.rims[f] >> k & 1) != 0)
        for (const std::size_t end : {k, (k + 1) % corners}) nth(patches.at_rim, of_corner[end]) = 1;
  }
  return patches;
}

std::vector<LocalIndex> sharp_nodes(std::span<const FacetNodes> facets, std::span<const Vec3> reference) {
  const std::vector<Vec3> normals = normals_of(facets, reference);
  std::vector<LocalIndex> nodes;
  for_neighbours(edge_sides(facets), [&](const EdgeSide& a, const EdgeSide& b) {
    if (is_ridge(facets, normals, reference, a, b)) nodes.insert(nodes.end(), {a.low, a.high});
  });
  sort_unique(nodes);
  return nodes;
}

std::vector<std::uint8_t> rims_of(std::span<const FacetNodes> facets, std::span<const Vec3> reference) {
  const std::vector<Vec3> normals = normals_of(facets, reference);
  const std::vector<EdgeSide> sides = edge_sides(facets);
  const auto bit = [](const EdgeSide& side) { return static_cast<std::uint8_t>(1U << side.first); };
  std::vector<std::uint8_t> rims(facets.size(), 0);
  for (const EdgeSide& side : sides) rims[side.facet] |= bit(side);
  for_neighbours(sides, [&](const EdgeSide& a, const EdgeSide& b) {
    if (is_ridge(facets, normals, reference, a, b)) return;
    for (const EdgeSide& side : {a, b}) rims[side.facet] &= static_cast<std::uint8_t>(~bit(side));
  });
  return rims;
}

}  // namespace brunt::contact
