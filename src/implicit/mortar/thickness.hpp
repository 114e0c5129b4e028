// SPDX-License-Identifier: Apache-2.0
// Surfaces of pairs at the start: the thickness of a body behind its facets, and edges where two surfaces meet.
#pragma once
#include <span>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::implicit {

/// For each facet: distance, along its normal and into its body, of the nearest facet of the same surface with an
/// opposite normal [length]; infinite if there is none within `reach`. x: positions of all nodes. flattest: share of
/// the mean edge up to which such a facet belongs to a surface that touches or overlaps, not to the other side of a
/// wall.
std::vector<double> thickness_behind(const std::vector<contact::FacetNodes>& facets, std::span<const Vec3> x,
                                     double reach, double flattest = 0);

/// Mean edges of both sides where they touch or overlap, weighted by the area that does. Surfaces farther apart are no
/// seat: nobody knows yet where they will meet.
struct SeatEdges {
  double area = 0;               ///< [length^2]
  double slave = 0, master = 0;  ///< [length]
};
/// touching: greatest gap of facets that touch [length].
SeatEdges edges_at_seat(const contact::MortarSurfaces& surfaces, std::span<const Vec3> x, double touching);

}  // namespace brunt::implicit
