// SPDX-License-Identifier: Apache-2.0
// Tractions of frictionless rows, from multipliers or a penalty, and their derivatives. The tractions of a Newton
// iterate:
//   mortar_rows -> tractions T_A -> add_forces;  then mortar_rows_and_slopes at T -> traction slopes ->
//   add_traction_slopes. Friction (friction.hpp) replaces the second step.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

struct TractionSlopes {
  NodeBlocks<Mat3> by_position;   ///< dT_A/dx_K at fixed pressures [force/length^3]
  std::vector<Vec3> by_pressure;  ///< dT_A/dz_A at fixed positions
};

/// T_A = z_A normal_A. z: pressures, one for each row [force/length^2].
void normal_tractions(const MortarRows& rows, std::span<const double> z, std::vector<Vec3>& tractions);

/// z_A d normal_A/dx, and the normals.
void normal_traction_slopes(const MortarRows& rows, const MortarSlopes& slopes, std::span<const double> z,
                            TractionSlopes& out);

/// z_A = max(0, base_A - stiffness gap_A / covered_A) if the row has a segment: eq. (23) with the mean gap over the
/// covered part, so that the stiffness of a row at an edge of the overlap equals that in its interior. base:
/// multipliers of the last augmentation; empty: zero. stiffness: [force/length^3].
void penalty_pressures(const MortarRows& rows, double stiffness, std::span<const double> base, std::vector<double>& z);

/// Adds dT_A/dz_A (x) dz_A/dx to the derivatives by position of the active rows. gradient: of gap_gradient.
void add_penalty_slopes(const MortarRows& rows, const NodeBlocks<Vec3>& gradient, const MortarSlopes& of_rows,
                        double stiffness, std::span<const std::uint8_t> pressed, TractionSlopes& slopes);

}  // namespace brunt::contact
