// SPDX-License-Identifier: Apache-2.0
// Sharp edges of a surface, and the smooth patches between them. The normal of a surface jumps at a sharp edge, so a
// node there has a row for each patch: its own normal, its own gap, its own pressure. In one row the open gap of the
// facets on one side of the edge would balance the penetration of those on the other side.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// Facets at an edge belong to one smooth patch if the product of their unit normals is larger (53 degrees): a circle
/// of eight facets is smooth, a corner of 120 degrees is not.
constexpr double smooth = 0.6;

/// Rows of a surface: one for each node and each smooth patch around it.
struct PatchRows {
  std::vector<LocalIndex> nodes;      ///< the node of each row, ascending; patches of a node in the order of facets
  std::vector<FacetNodes> of_corner;  ///< for each facet: the rows of its corners
};

/// reference: positions of all nodes.
PatchRows patch_rows(std::span<const FacetNodes> facets, std::span<const Vec3> reference);

/// Patches of facets from the numbers of their corners' patches.
NodePatches patches_of(std::span<const PatchNumbers> facets);

/// As NodePatches::rims: sides without a neighbour, and convex sharp edges.
std::vector<std::uint8_t> rims_of(std::span<const FacetNodes> facets, std::span<const Vec3> reference);

/// For each facet the colour of its smooth region, which ends at sharp edges. Regions that share a node have different
/// colours: the sides of a box have three.
std::vector<std::size_t> region_colours(std::span<const FacetNodes> facets, std::span<const Vec3> reference);

/// Nodes of convex sharp edges, ascending.
std::vector<LocalIndex> sharp_nodes(std::span<const FacetNodes> facets, std::span<const Vec3> reference);

}  // namespace brunt::contact
