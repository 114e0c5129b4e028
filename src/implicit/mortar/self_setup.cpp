// SPDX-License-Identifier: Apache-2.0
// Set-up of contact of a part with itself.
#include <algorithm>

#include "contact/mortar/corners.hpp"
#include "contact/mortar/segment.hpp"
#include "implicit/mortar/thickness.hpp"
#include "near_facets.hpp"
#include "self_sides.hpp"

namespace brunt::implicit {
namespace {

using contact::FacetNodes;

/// The capture distance over the thinnest wall: a facet must not see another one through a wall between them, not even
/// where the wall is compressed to this share of its thickness.
constexpr double of_thinnest = 0.5;

/// Facets whose planes lie behind each other by less than this share of an edge touch or overlap initially; deeper ones
/// are the two sides of a wall. Overlaps are admitted up to 1e-4 of an edge, elements are never as flat.
constexpr double flattest_wall = 1e-2;

/// Longest edges between the two sides of a wall, and the product of their unit normals below which they are the sides
/// of one. They stay so if the wall is sheared by three or compressed to a sixth, or if its tip, of up to 120 degrees
/// initially, becomes sharp.
constexpr double edges_of_wall = 3, wall_normals = 0.5;

struct Facet {
  Vec3 centre = Vec3::Zero(), normal = Vec3::Zero();
  double mean = 0, longest = 0;  ///< edges [length]

  Facet(const FacetNodes& nodes, std::span<const Vec3> x) {
    const contact::CornersOf corners(nodes, x);
    contact::SlavePlane plane;
    if (contact::make_slave_plane(corners.span(), plane)) normal = plane.normal;
    const auto n = static_cast<double>(corners.count);
    for (std::size_t k = 0; k < corners.count; ++k) {
      const double edge = (corners.x[(k + 1) % corners.count] - corners.x[k]).norm();
      centre += corners.x[k] / n;
      mean += edge / n;
      longest = std::max(longest, edge);
    }
  }
};

bool share_node(const FacetNodes& one, const FacetNodes& other) {
  return std::ranges::any_of(
      one, [&](LocalIndex node) { return node != no_index && std::ranges::find(other, node) != other.end(); });
}

bool are_sides_of_wall(const Facet& one, const Facet& other) {
  const Vec3 between = other.centre - one.centre;
  const double least = flattest_wall * std::min(one.mean, other.mean);
  return one.normal.dot(other.normal) < wall_normals && between.dot(one.normal) < -least &&
         between.dot(other.normal) > least && between.norm() < edges_of_wall * std::max(one.longest, other.longest);
}

std::vector<Facet> facets_of(const std::vector<FacetNodes>& nodes, std::span<const Vec3> x) {
  std::vector<Facet> facets;
  for (const FacetNodes& facet : nodes) facets.emplace_back(facet, x);
  return facets;
}

double longest_of(const std::vector<Facet>& facets) {
  double longest = 0;
  for (const Facet& facet : facets) longest = std::max(longest, facet.longest);
  return longest;
}

}  // namespace

void lay_self(const WholeSurfaces& whole, WholeInterface& of) {
  of.slave = of.master = side_of(whole, of.face.pair.slave);
  contact::MortarSurfaces& surfaces = of.face.surfaces;
  surfaces.slave = surfaces.master = of.slave.facets;
  SelfContact self;
  self.key = of.slave.key;
  const std::vector<Facet> facets = facets_of(of.slave.facets, whole.reference);
  for (const Facet& facet : facets) self.edge.push_back(facet.mean);
  self.roles.assign(self.key.size(), contact::FacetRole::none);
  const double longest = longest_of(facets);
  surfaces.slave_wall = thickness_behind(surfaces.slave, whole.reference, longest, flattest_wall);
  surfaces.master_wall = surfaces.slave_wall;
  surfaces.capture = longest;
  for (const double wall : surfaces.slave_wall) surfaces.capture = std::min(surfaces.capture, of_thinnest * wall);
  of.face.self = std::move(self);
}

void share_self(const std::vector<FacetNodes>& facets, std::span<const Vec3> reference,
                const std::vector<std::size_t>& mine, SelfContact& self) {
  std::vector<FacetNodes> own;
  for (const std::size_t facet : mine) {
    own.push_back(facets[facet]);
    self.slave.push_back(static_cast<LocalIndex>(facet));
  }
  const std::vector<Facet> all = facets_of(facets, reference);
  const std::vector<contact::FacetPair> pairs = near_facets(own, facets, reference, edges_of_wall * longest_of(all));
  auto pair = pairs.begin();
  for (std::size_t k = 0; k < mine.size(); ++k) {
    for (; pair != pairs.end() && pair->slave == static_cast<LocalIndex>(k); ++pair) {
      const auto other = static_cast<std::size_t>(pair->master);
      if (share_node(own[k], facets[other]) || are_sides_of_wall(all[mine[k]], all[other]))
        self.never.values.push_back(pair->master);
    }
    self.never.close_row();
  }
}

}  // namespace brunt::implicit
