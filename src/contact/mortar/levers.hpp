// SPDX-License-Identifier: Apache-2.0
// Forces that are the exact gradient of the weighted gaps. The gap of a row is g_A = n_A . sum_K w_AK x_K, so a
// pressure z_A that does the work z_A dg_A acts on node K with
//   F_K = z_A h_AK,  h_AK = dg_A/dx_K = w_AK n_A + l_AK.
// The traction z_A n_A distributed by the weights is its first part; the levers l_AK are what the motion of a node
// changes in the weights and the normal. A gap depends neither on the place nor on the orientation of the whole, so
// these forces have neither a resultant nor a moment.
//
// A penalty has the energy  k g_A^2 / (2 c_A)  with c_A = covered_A, so its levers contain  z_A/(2k) dc_A/dx_K, too.
#pragma once
#include <span>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// l_AK, one entry for each row [length^2]. gradient: of gap_gradient.
void gap_levers(const MortarRows& rows, const NodeBlocks<Vec3>& gradient, NodeBlocks<Vec3>& levers);

/// Adds the part of a penalty for its pressures z.
void add_penalty_levers(const MortarSlopes& slopes, double stiffness, std::span<const double> z,
                        NodeBlocks<Vec3>& levers);

/// Derivatives of z_A l_AK at fixed pressures, one patch for each row with a pressure: products of first derivatives
///   z_A ((dG_A/dx_K - w_AK 1)^T dn_A/dx_L + (dn_A/dx_K)^T dG_A/dx_L).
/// The rest, sum_K dw_AK/dx_L (x) n_A, is the transpose of the patches of MortarSlopes::weights and is added there.
/// Second derivatives of weights and normals are left out: Newton's iteration converges at a linear rate.
void lever_patches(const MortarRows& rows, const MortarSlopes& slopes, std::span<const double> z, Patches& patches);

/// Adds  (l_AK + z_A/(2k) dc_A/dx_K) (x) dz_A/dx_L  of a penalty to the patches of the rows. levers: with the part of
/// the penalty.
void add_penalty_lever_patches(const MortarRows& rows, const MortarSlopes& slopes, const NodeBlocks<Vec3>& gradient,
                               const NodeBlocks<Vec3>& levers, double stiffness, std::span<const double> z,
                               Patches& patches);

}  // namespace brunt::contact
