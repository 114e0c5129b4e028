// SPDX-License-Identifier: Apache-2.0
// Exact multipliers by the primal-dual active set.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// Stiffness of a layer with the thickness of one facet: Young's modulus over the mean edge of the slave facets
/// [force/length^3]. The constant c of the active set (only its order of magnitude matters), and the unit of the
/// penalty stiffness.
double layer_stiffness(double young, const MortarTopology& topology);

/// active[A] = 1 where z_A - c (gap_A - least_A) / covered_A > 0 and the row has a segment (Hueber and Wohlmuth 2005).
/// Returns the number of changed entries. z: pressures [force/length^2]; least: the required weighted gaps of the rows
/// [length^3], zero if empty. The equations of the rows are then
///   active: (gap_A - least_A) / covered_A = 0; inactive: z_A = 0.
/// (Divided by the covered area: the weighted gap of a sliver vanishes with its area, without closing the gap.)
std::size_t choose_active(const MortarRows& rows, std::span<const double> z, double c,
                          std::vector<std::uint8_t>& active, std::span<const double> least = {});

}  // namespace brunt::contact
