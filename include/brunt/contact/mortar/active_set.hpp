// SPDX-License-Identifier: Apache-2.0
// Exact multipliers by the primal-dual active set.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// Stiffness of a layer of one facet's thickness: Young's modulus over the mean edge of the slave's facets
/// [force/length^3]. The constant c of the active set (any of this size does), and the unit of penalty stiffness.
double layer_stiffness(double young, const MortarTopology& topology);

/// active[A] = 1 where z_A - c kappa_A gap_A > 0 and the row has a segment (Hueber and Wohlmuth 2005). Returns how many
/// entries changed. z: pressures [force/length^2]. The rows' equations are then
///   active: kappa_A gap_A = 0, linearised by gap_gradient; inactive: z_A = 0.
std::size_t choose_active(const MortarRows& rows, const MortarTopology& topology, std::span<const double> z, double c,
                          std::vector<std::uint8_t>& active);

}  // namespace brunt::contact
