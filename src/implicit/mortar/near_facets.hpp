// SPDX-License-Identifier: Apache-2.0
// Facets of two surfaces that are near each other, at the start.
#pragma once
#include <span>
#include <vector>

#include "contact/search/facet_tree.hpp"

namespace brunt::implicit {

/// Pairs whose bounding volumes come nearer than `reach` [length]; facets of one surface with itself if both are the
/// same. x: positions of all nodes.
std::vector<contact::FacetPair> near_facets(const std::vector<contact::FacetNodes>& slave,
                                            const std::vector<contact::FacetNodes>& master, std::span<const Vec3> x,
                                            double reach);

}  // namespace brunt::implicit
