// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "contact/mortar/corners.hpp"
#include "contact/mortar/interface.hpp"
#include "core/error.hpp"
#include "facet_map.hpp"

namespace brunt::contact {

namespace {

/// int N_A over the whole facet, on its plane [length^2]. The Jacobian of the bilinear map is linear in xi and eta.
std::array<double, 4> whole_shares(FacetCorners x) {
  SlavePlane plane;
  if (!make_slave_plane(x, plane)) return {};
  if (x.size() == 3) {
    const double third = plane.area() / 3;
    return {third, third, third, 0};
  }
  const FacetMap map({plane.point.data(), 4});
  const double mean = cross(map.along_xi, map.along_eta), by_xi = cross(map.along_xi, map.twist) / 3,
               by_eta = cross(map.twist, map.along_eta) / 3;
  return {mean - by_xi - by_eta, mean + by_xi - by_eta, mean + by_xi + by_eta, mean - by_xi + by_eta};
}

/// One row for each node that has one.
std::vector<FacetNodes> rows_of_nodes(const MortarSurfaces& surfaces, std::size_t nodes) {
  std::vector<LocalIndex> row_of_node(nodes, no_index);
  LocalIndex next = 0;
  for (const std::vector<LocalIndex>* of : {&surfaces.rows, &surfaces.rows_elsewhere})
    for (const LocalIndex node : *of) nth(row_of_node, node) = next++;
  std::vector<FacetNodes> of_corner;
  for (const FacetNodes& facet : surfaces.slave) {
    FacetNodes& rows = of_corner.emplace_back();
    for (std::size_t a = 0; a < facet.size(); ++a)
      rows[a] = facet[a] == no_index ? no_index : nth(row_of_node, facet[a]);
  }
  return of_corner;
}

}  // namespace

MortarTopology make_topology(const MortarSurfaces& surfaces, std::span<const Vec3> reference) {
  MortarTopology topology;
  const std::size_t rows = surfaces.rows.size();
  topology.row_of_corner =
      surfaces.corner_rows.empty() ? rows_of_nodes(surfaces, reference.size()) : surfaces.corner_rows;
  Ragged<LocalIndex> rows_of_facets;
  std::vector<double> share(rows, 0);
  double edges = 0;
  std::size_t edge_count = 0;
  for (std::size_t facet = 0; facet < surfaces.slave.size(); ++facet) {
    const CornersOf corners(surfaces.slave[facet], reference);
    const std::array<double, 4> whole = whole_shares(corners.span());
    for (std::size_t a = 0; a < corners.count; ++a) {
      edges += (corners.x[(a + 1) % corners.count] - corners.x[a]).norm();
      ++edge_count;
      const LocalIndex row = topology.row_of_corner[facet][a];
      if (row == no_index || static_cast<std::size_t>(row) >= rows) continue;
      rows_of_facets.values.push_back(row);
      nth(share, row) += whole[a];
    }
    rows_of_facets.close_row();
  }
  transpose(rows_of_facets, rows, topology.facets_around);
  if (edge_count > 0) topology.edge = edges / static_cast<double>(edge_count);
  for (const double of_row : share) {
    demand(of_row > 0, "mortar: the node of a row has no slave facet of positive area");
    topology.kappa.push_back(1 / of_row);
  }
  return topology;
}

}  // namespace brunt::contact
