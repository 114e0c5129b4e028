// SPDX-License-Identifier: Apache-2.0
// Nodal forces of the multipliers and their linearisation: sums over the rows of an interface. With tractions T_A and
// their derivatives dT_A/dx the tangent of the forces is the sum of two lists of patches:
//   dF_K/dx_L = sum_A T_A (x) dw_AK/dx_L (MortarSlopes::weights) + sum_A w_AK dT_A/dx_L (add_traction_slopes).
#pragma once
#include <span>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// forces[K] += w_AK T_A over all rows, in their order [force].
void add_forces(const MortarRows& rows, std::span<const Vec3> tractions, std::span<Vec3> forces);

/// K_xz: dF_K/dz_A = w_AK dT_A/dz_A, one entry for each row [length^2]. by_pressure: dT_A/dz_A, the normals without
/// friction.
void pressure_columns(const MortarRows& rows, std::span<const Vec3> by_pressure, NodeBlocks<Vec3>& columns);

/// K_zx: h_A = d(normal_A . G_A)/dx, one entry for each row; rows without a segment are empty [length^2].
void gap_gradient(const MortarRows& rows, const MortarSlopes& slopes, NodeBlocks<Vec3>& gradient);

/// The gaps of these rows at other positions y, with the current normals and weights: normal_A . sum_K w_AK y_K
/// [length^3], and d/dx at fixed y [length^2]; slopes: computed with `fixed` = y.
void gaps_at(const MortarRows& rows, std::span<const Vec3> y, std::vector<double>& gaps);
void gaps_at_gradient(const MortarRows& rows, const MortarSlopes& slopes, std::span<const Vec3> y,
                      NodeBlocks<Vec3>& gradient);

/// Appends a patch for each row whose traction has derivatives: w_AK dT_A/dx_L.
void add_traction_slopes(const MortarRows& rows, const NodeBlocks<Mat3>& traction_slopes, Patches& patches);

}  // namespace brunt::contact
