// SPDX-License-Identifier: Apache-2.0
#include "implicit/mortar/thickness.hpp"

#include <algorithm>
#include <limits>

#include "contact/mortar/corners.hpp"
#include "contact/mortar/segment.hpp"
#include "core/cells.hpp"
#include "near_facets.hpp"

namespace brunt::implicit {
namespace {

double mean_edge(const contact::FacetNodes& facet, std::span<const Vec3> x) {
  const std::size_t n = cells::corner_count(facet);
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += (nth(x, facet[k]) - nth(x, facet[(k + 1) % n])).norm();
  return sum / static_cast<double>(n);
}

}  // namespace

std::vector<double> thickness_behind(const std::vector<contact::FacetNodes>& facets, std::span<const Vec3> x,
                                     double reach, double flattest) {
  std::vector<double> wall(facets.size(), std::numeric_limits<double>::infinity());
  contact::SlavePlane plane;
  contact::SegmentIntegrals integrals;
  for (const contact::FacetPair& pair : near_facets(facets, facets, x, reach)) {
    const auto one = static_cast<std::size_t>(pair.slave), other = static_cast<std::size_t>(pair.master);
    if (!contact::make_slave_plane(contact::CornersOf(facets[one], x).span(), plane)) continue;
    const contact::CornersOf behind(facets[other], x);
    if (!contact::integrate_segment(plane, behind.span(), reach, integrals) || integrals.distance >= 0) continue;
    if (flattest > 0 &&
        -integrals.distance <= flattest * std::min(mean_edge(facets[one], x), mean_edge(facets[other], x)))
      continue;
    wall[one] = std::min(wall[one], -integrals.distance);
  }
  return wall;
}

SeatEdges edges_at_seat(const contact::MortarSurfaces& surfaces, std::span<const Vec3> x, double touching) {
  SeatEdges seat;
  contact::SlavePlane plane;
  contact::SegmentIntegrals segment;
  for (const contact::FacetPair& pair : near_facets(surfaces.slave, surfaces.master, x, surfaces.capture)) {
    const auto s = static_cast<std::size_t>(pair.slave), m = static_cast<std::size_t>(pair.master);
    const contact::FacetNodes &from = surfaces.slave[s], &to = surfaces.master[m];
    if (!contact::make_slave_plane(contact::CornersOf(from, x).span(), plane) ||
        !contact::integrate_segment(plane, contact::CornersOf(to, x).span(), surfaces.capture, segment))
      continue;
    if (segment.distance > touching || segment.distance < -surfaces.deepest(s, m)) continue;
    seat.area += segment.area;
    seat.slave += segment.area * mean_edge(from, x);
    seat.master += segment.area * mean_edge(to, x);
  }
  if (seat.area > 0) {
    seat.slave /= seat.area;
    seat.master /= seat.area;
  }
  return seat;
}

}  // namespace brunt::implicit
