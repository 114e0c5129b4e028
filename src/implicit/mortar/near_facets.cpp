// SPDX-License-Identifier: Apache-2.0
#include "near_facets.hpp"

namespace brunt::implicit {

std::vector<contact::FacetPair> near_facets(const std::vector<contact::FacetNodes>& slave,
                                            const std::vector<contact::FacetNodes>& master, std::span<const Vec3> x,
                                            double reach) {
  std::vector<contact::FacetPair> pairs;
  if (slave.empty() || master.empty()) return pairs;
  contact::KdopTree one, other;
  contact::build(one, slave, x);
  contact::build(other, master, x);
  contact::refit(one, x, contact::by_distance(0.5 * reach));
  contact::refit(other, x, contact::by_distance(0.5 * reach));
  contact::TraversalScratch scratch;
  contact::find_pairs(one, other, scratch, pairs);
  return pairs;
}

}  // namespace brunt::implicit
