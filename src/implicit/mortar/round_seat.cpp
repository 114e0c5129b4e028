// SPDX-License-Identifier: Apache-2.0
#include "implicit/mortar/round_seat.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "contact/mortar/corners.hpp"
#include "contact/mortar/segment.hpp"
#include "core/cells.hpp"
#include "near_facets.hpp"

namespace brunt::implicit {
namespace {

using contact::FacetNodes;

/// Facets belong to one round surface if the product of their unit normals is larger (37 degrees): a circle of ten
/// facets is round, an edge of a box is not.
constexpr double round = 0.8;

/// For each facet: mean height of the round surface through its nodes above it, positive outside: the twelfth part of
/// edge^2 times curvature in each of two directions, with the curvature from the normals at the ends of its edges.
std::vector<double> bulges(const std::vector<FacetNodes>& facets, std::span<const Vec3> x) {
  std::vector<Vec3> normals;
  std::unordered_map<LocalIndex, std::vector<std::size_t>> around;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    contact::SlavePlane plane;
    normals.push_back(contact::make_slave_plane(contact::CornersOf(facets[f], x).span(), plane) ? plane.normal
                                                                                                : Vec3(Vec3::Zero()));
    for (std::size_t k = 0; k < cells::corner_count(facets[f]); ++k) around[facets[f][k]].push_back(f);
  }
  std::vector<double> heights;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const std::size_t n = cells::corner_count(facets[f]);
    std::array<Vec3, 4> at;
    for (std::size_t k = 0; k < n; ++k) {
      at[k] = Vec3::Zero();
      for (const std::size_t other : around[facets[f][k]])
        if (normals[other].dot(normals[f]) > round) at[k] += normals[other];
      at[k].normalize();
    }
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      const Vec3 edge = nth(x, facets[f][next]) - nth(x, facets[f][k]);
      sum += (at[next] - at[k]).dot(edge);
    }
    heights.push_back(sum / 24);
  }
  return heights;
}

/// How deep a corner that lies behind the facet of this plane does; 0 if none does.
double deepest_corner(contact::FacetCorners corners, const contact::SlavePlane& plane) {
  constexpr double beside = 1e-9;  // of a facet: a corner on its side belongs to it
  double deepest = 0;
  for (const Vec3& corner : corners) {
    const Vec3 from = corner - plane.centre;
    const double x = from.dot(plane.first), y = from.dot(plane.second);
    bool inside = true;
    for (std::size_t k = 0, n = static_cast<std::size_t>(plane.corners); k < n; ++k) {
      const auto &here = plane.point[k], &next = plane.point[(k + 1) % n];
      const double left = (next.x - here.x) * (y - here.y) - (next.y - here.y) * (x - here.x);
      inside = inside && left >= -beside * plane.twice_area;
    }
    if (inside) deepest = std::max(deepest, -from.dot(plane.normal));
  }
  return deepest;
}

}  // namespace

RoundSeat round_seat(const contact::MortarSurfaces& surfaces, std::span<const Vec3> x, double reach) {
  RoundSeat seat;
  double area = 0, bulge_of_slave = 0, bulge_of_master = 0;
  const std::vector<double> of_slave = bulges(surfaces.slave, x), of_master = bulges(surfaces.master, x);
  contact::SlavePlane plane, of_master_facet;
  contact::SegmentIntegrals segment;
  for (const contact::FacetPair& pair : near_facets(surfaces.slave, surfaces.master, x, reach)) {
    const auto s = static_cast<std::size_t>(pair.slave), m = static_cast<std::size_t>(pair.master);
    const contact::CornersOf slave(surfaces.slave[s], x), master(surfaces.master[m], x);
    if (!contact::make_slave_plane(slave.span(), plane) || !contact::make_slave_plane(master.span(), of_master_facet) ||
        !contact::integrate_segment(plane, master.span(), reach, segment) || segment.distance < -surfaces.deepest(s, m))
      continue;
    seat.deepest =
        std::max({seat.deepest, deepest_corner(master.span(), plane), deepest_corner(slave.span(), of_master_facet)});
    const double depth = of_slave[s] + of_master[m] - segment.distance;
    if (!(depth > 0)) continue;
    area += segment.area;
    bulge_of_slave += segment.area * of_slave[s];
    bulge_of_master += segment.area * of_master[m];
    seat.of_facets -= segment.area * segment.distance;
    seat.of_surfaces += segment.area * depth;
  }
  seat.conform = bulge_of_slave * bulge_of_master < 0;
  if (area > 0) {
    seat.of_facets /= area;
    seat.of_surfaces /= area;
  }
  return seat;
}

}  // namespace brunt::implicit
