// SPDX-License-Identifier: Apache-2.0
// Coulomb friction of mortar rows, eqs. (26) to (29) of Yang and Laursen (2008): slip is measured by the change of the
// mortar weights over the step, which is invariant under a rigid motion of both bodies; sticking is a penalty.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/mortar/tractions.hpp"

namespace brunt::contact {

struct MortarFriction {
  double coefficient = 0;  ///< of Coulomb
  double stiffness = 0;    ///< tangential, of sticking rows [force/length^3]
};

/// History of the last step, one entry for each row. A row without previous weights has neither slip nor traction.
struct FrictionHistory {
  NodeBlocks<double> weights;   ///< w_AK [length^2]
  std::vector<double> covered;  ///< [length^2]
  std::vector<Vec3> normals;    ///< unit
  std::vector<Vec3> tractions;  ///< tangential part on the slave [force/length^2]
};

enum class FrictionState : std::int8_t { open, stick, slip };

/// Slip of the slave relative to the master over the step [length], one entry for each row:
/// s_A = - (1 - n n^T) sum_K (w_AK / covered_A - the same of the last step) x_K: means over the covered part, so that
/// the sticking stiffness at an edge of the overlap equals that in its interior.
void slips(const MortarRows& rows, std::span<const Vec3> x, const FrictionHistory& history, std::vector<Vec3>& out);

/// T_A = z_A normal_A + t_A with t_A = t_tr if |t_tr| <= mu z_A (stick), otherwise mu z_A t_tr/|t_tr|;
/// t_tr = (t of the last step, rotated with the normal) - stiffness s_A. Rows with z_A <= 0 have no traction.
void friction_tractions(const MortarRows& rows, std::span<const Vec3> x, std::span<const double> z,
                        const MortarFriction& law, const FrictionHistory& history, std::vector<Vec3>& tractions,
                        std::vector<FrictionState>& states);

/// Their derivatives, along the branch taken. assumed: rows that are assumed to stick although they have no pressure;
/// or empty.
void friction_traction_slopes(const MortarRows& rows, const MortarSlopes& slopes, std::span<const Vec3> x,
                              std::span<const double> z, const MortarFriction& law, const FrictionHistory& history,
                              TractionSlopes& out, std::span<const std::uint8_t> assumed = {});

/// The history of a step that is accepted.
void keep_friction(const MortarRows& rows, std::span<const Vec3> tractions, FrictionHistory& history);

}  // namespace brunt::contact
