// SPDX-License-Identifier: Apache-2.0
// Frictionless contact with exact multipliers by the primal-dual active set.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// T_A = z_A normal_A. z: pressures, a row each [force/length^2].
void normal_tractions(const MortarRows& rows, std::span<const double> z, std::vector<Vec3>& tractions);

/// dT_A/dx at fixed z: z_A d normal_A/dx; rows with z = 0 are empty.
void normal_traction_slopes(const MortarSlopes& slopes, std::span<const double> z, NodeBlocks<Mat3>& traction_slopes);

/// The constant c of the rule: Young's modulus (the softer side's) over the mean edge [force/length^3].
double active_set_scale(double young, const MortarTopology& topology);

/// active[A] = 1 where z_A - c kappa_A gap_A > 0 and the row has a segment (Hueber and Wohlmuth 2005). Returns how many
/// entries changed.
std::size_t choose_active(const MortarRows& rows, const MortarTopology& topology, std::span<const double> z,
                          double scale, std::vector<std::uint8_t>& active);

}  // namespace brunt::contact
