// SPDX-License-Identifier: Apache-2.0
// Rotations of nodes of shells: arrays beside the nodes, indexed as these, which exist only where a part of the model
// is a shell. A node turns if it is a corner of a shell on any rank; every rank that holds it has the same bits.
#pragma once
#include "core/simd.hpp"
#include "core/types.hpp"

namespace brunt::model {

/// One cache line for each node, so that a shell gathers the rotation of a corner with one load.
struct alignas(64) RotationLine {
  double rate[3];  ///< at the half step: Cayley's vector of the rotation of the step over dt [1/time]
  double inertia;  ///< lumped, the same about all axes [mass length^2]; 0: the node does not turn
  double turn[4];  ///< rotation from t = 0 to t_n: unit quaternion x, y, z, w
  [[nodiscard]] Quad& rate_inertia() { return *reinterpret_cast<Quad*>(rate); }
};

/// Work of moments on a node and angular impulse of its supports, up to the half step: impulses times mean rates.
struct RotationAccount {
  double element_work = 0, load_work = 0, damping_work = 0, reaction_work = 0;  ///< [energy]
  double reaction_impulse[3] = {};  ///< of moments of supports [moment time]
};
constexpr int rotation_account_width = 7;
static_assert(sizeof(RotationAccount) == rotation_account_width * sizeof(double));

}  // namespace brunt::model
