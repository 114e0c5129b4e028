// SPDX-License-Identifier: Apache-2.0
// Thickness of a body behind the facets of its surface.
#pragma once
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::implicit {

/// For each facet: distance, along its normal and into its body, of the nearest facet of the same surface with an
/// opposite normal [length]; infinite if there is none within `reach`. x: positions of all nodes.
std::vector<double> thickness_behind(const std::vector<contact::FacetNodes>& facets, std::span<const Vec3> x,
                                     double reach);

}  // namespace brunt::implicit
