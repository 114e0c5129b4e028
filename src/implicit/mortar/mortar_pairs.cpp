// SPDX-License-Identifier: Apache-2.0
#include "mortar_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/mortar/patches.hpp"
#include "core/cells.hpp"
#include "core/sorted.hpp"

namespace brunt::implicit {
namespace {

using contact::FacetNodes;

WholeSide chosen(const WholeSide& side, const std::vector<std::size_t>& facets) {
  WholeSide some;
  for (const std::size_t facet : facets) {
    some.facets.push_back(side.facets[facet]);
    some.key.push_back(side.key[facet]);
    some.rank.push_back(side.rank[facet]);
  }
  return some;
}

std::vector<double> chosen(const std::vector<double>& walls, const std::vector<std::size_t>& facets) {
  std::vector<double> some;
  for (const std::size_t facet : facets) some.push_back(walls[facet]);
  return some;
}

WholeInterface beside(const WholeInterface& pair) {
  WholeInterface of;
  of.face.pair = pair.face.pair;
  of.face.of_pair = pair.face.of_pair;
  of.face.first_of_pair = false;
  of.face.stiffness = pair.face.stiffness;
  of.face.friction = pair.face.friction;
  return of;
}

/// The same slave with other masters.
WholeInterface with_masters(const WholeInterface& pair, const std::vector<std::size_t>& masters) {
  WholeInterface of = beside(pair);
  const contact::MortarSurfaces& all = pair.face.surfaces;
  contact::MortarSurfaces& surfaces = of.face.surfaces;
  of.slave = pair.slave;
  of.master = chosen(pair.master, masters);
  surfaces = all;
  surfaces.master = of.master.facets;
  surfaces.master_wall = chosen(all.master_wall, masters);
  of.face.topology = pair.face.topology;
  return of;
}

/// Whether a plane of symmetry contains both nodes: a surface does not end there. (Opposite planes of a slice have one
/// normal.)
bool in_one_mirror(const WholeSurfaces& whole, LocalIndex one, LocalIndex other) {
  constexpr double parallel = 1 - 1e-12;  // product of unit normals
  constexpr double within = 1e-6;         // sine between the plane and the way from node to node
  const Vec3 way = nth(whole.reference, other) - nth(whole.reference, one);
  const Ragged<Vec3> mirrors = mirrors_at(whole, std::array{one, other});
  return std::ranges::any_of(mirrors.row(0), [&](const Vec3& a) {
    return std::abs(a.dot(way)) <= within * way.norm() &&
           std::ranges::any_of(mirrors.row(1), [&](const Vec3& b) { return std::abs(a.dot(b)) > parallel; });
  });
}

std::vector<contact::PatchNumbers> patches_of_masters(const WholeSurfaces& whole,
                                                      const std::vector<FacetNodes>& facets) {
  const std::vector<FacetNodes> rows = contact::patch_rows(facets, whole.reference).of_corner;
  const std::vector<std::uint8_t> rims = contact::rims_of(facets, whole.reference);
  std::vector<contact::PatchNumbers> patches;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    contact::PatchNumbers& of = patches.emplace_back();
    std::ranges::copy(rows[f], of.of_corner.begin());
    const std::size_t corners = cells::corner_count(facets[f]);
    for (std::size_t k = 0; k < corners; ++k)
      if ((rims[f] >> k & 1) != 0 && !in_one_mirror(whole, facets[f][k], facets[f][(k + 1) % corners]))
        of.rims |= std::int64_t{1} << k;
  }
  return patches;
}

/// Rows of the nodes of sharp edges of one side on the facets of the other.
WholeInterface points_of(const WholeSurfaces& whole, const WholeInterface& pair, bool of_slave) {
  WholeInterface of = beside(pair);
  Interface& face = of.face;
  face.of_points = true;
  if (!of_slave) std::swap(face.pair.slave, face.pair.master);
  of.master = of_slave ? pair.master : pair.slave;
  of.master_patch = patches_of_masters(whole, of.master.facets);
  const contact::MortarSurfaces& all = pair.face.surfaces;
  contact::MortarSurfaces& surfaces = face.surfaces;
  surfaces.capture = all.capture;
  surfaces.master = of.master.facets;
  surfaces.master_wall = of_slave ? all.master_wall : all.slave_wall;
  const WholeSide& side = of_slave ? pair.slave : pair.master;
  surfaces.rows = contact::sharp_nodes(side.facets, whole.reference);
  surfaces.mirrors = mirrors_at(whole, surfaces.rows);
  std::vector<std::size_t> around;
  for (std::size_t facet = 0; facet < side.facets.size(); ++facet)
    if (std::ranges::any_of(side.facets[facet],
                            [&](LocalIndex node) { return std::ranges::binary_search(surfaces.rows, node); }))
      around.push_back(facet);
  of.slave = chosen(side, around);
  surfaces.slave = of.slave.facets;
  surfaces.slave_wall = chosen(of_slave ? all.slave_wall : all.master_wall, around);
  face.topology = contact::make_topology(surfaces, whole.reference);
  face.topology.edge = pair.face.topology.edge;
  return of;
}

}  // namespace

void lay_rows(const WholeSurfaces& whole, bool by_patch, contact::MortarSurfaces& surfaces) {
  contact::PatchRows rows = contact::patch_rows(surfaces.slave, whole.reference);
  surfaces.rows = std::move(rows.nodes);
  if (by_patch) {
    surfaces.corner_rows = std::move(rows.of_corner);
    const std::vector<LocalIndex> sharp = contact::sharp_nodes(surfaces.slave, whole.reference);
    for (const FacetNodes& facet : surfaces.slave)
      surfaces.at_edge.push_back(
          std::ranges::any_of(facet, [&](LocalIndex node) { return std::ranges::binary_search(sharp, node); }));
  } else
    sort_unique(surfaces.rows);
  surfaces.mirrors = mirrors_at(whole, surfaces.rows);
}

std::vector<WholeInterface> split_at_edges(const WholeSurfaces& whole, WholeInterface pair) {
  std::vector<WholeInterface> interfaces;
  if (pair.face.pair.edges) {
    std::vector<std::vector<std::size_t>> masters;  // by colour
    const std::vector<std::size_t> colours = contact::region_colours(pair.master.facets, whole.reference);
    for (std::size_t facet = 0; facet < colours.size(); ++facet) {
      if (colours[facet] >= masters.size()) masters.resize(colours[facet] + 1);
      masters[colours[facet]].push_back(facet);
    }
    for (const std::vector<std::size_t>& of_colour : masters) interfaces.push_back(with_masters(pair, of_colour));
    for (const bool of_slave : {true, false}) {
      WholeInterface points = points_of(whole, pair, of_slave);
      if (points.face.count() > 0) interfaces.push_back(std::move(points));
    }
  }
  if (interfaces.size() < 2) {
    interfaces.clear();
    interfaces.push_back(std::move(pair));
  }
  interfaces.front().face.first_of_pair = true;
  return interfaces;
}

}  // namespace brunt::implicit
