// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/thickness.hpp"

#include <algorithm>
#include <limits>

#include "brunt/contact/mortar/corners.hpp"
#include "brunt/contact/mortar/segment.hpp"
#include "brunt/contact/search/facet_tree.hpp"

namespace brunt::implicit {
std::vector<double> thickness_behind(const std::vector<contact::FacetNodes>& facets, std::span<const Vec3> x,
                                     double reach) {
  std::vector<double> wall(facets.size(), std::numeric_limits<double>::infinity());
  if (facets.empty()) return wall;
  contact::KdopTree tree;
  contact::build(tree, facets, x);
  contact::refit(tree, x, contact::by_distance(0.5 * reach));
  contact::TraversalScratch scratch;
  std::vector<contact::FacetPair> pairs;
  contact::find_pairs(tree, tree, scratch, pairs);
  contact::SlavePlane plane;
  contact::SegmentIntegrals integrals;
  for (const contact::FacetPair& pair : pairs) {
    const auto one = static_cast<std::size_t>(pair.slave), other = static_cast<std::size_t>(pair.master);
    if (!contact::make_slave_plane(contact::CornersOf(facets[one], x).span(), plane)) continue;
    const contact::CornersOf behind(facets[other], x);
    if (!contact::integrate_segment(plane, behind.span(), reach, integrals) || integrals.distance >= 0) continue;
    wall[one] = std::min(wall[one], -integrals.distance);
  }
  return wall;
}

}  // namespace brunt::implicit
