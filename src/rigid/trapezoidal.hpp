// SPDX-License-Identifier: Apache-2.0
// A rigid body over one implicit step: the trapezoidal rule for rotations.
//
// With the angular velocity W = R^T omega in the body's axes and h the half turn of the step (rigid/rotation.hpp),
//   R_{n+1} = cay(2 h) R_n,  (W_n + W_{n+1})/2 = 2 R_n^T h/dt,  l_{n+1} - l_n = dt tau,  l = R J W.
// Since h is an axis of the rotation, l_{n+1} - l_n does the work 2 h . (l_{n+1} - l_n)/dt, which is exactly the change
// of the kinetic energy. A body free of moments conserves angular momentum and energy, and forces on points r with the
// arms (r_n + r_{n+1})/2 do the same work on the body as on the displacement of these points. Without moments it equals
// the rule of rigid/body.hpp. J. C. Simo, K. K. Wong, Int. J. Numer. Meth. Engng 31 (1991) 19-52 (with the Cayley
// transform).
#pragma once
#include "rigid/body.hpp"

namespace brunt::rigid {

/// W [rad/time].
[[nodiscard]] Vec3 body_spin(const Body& body, const BodyState& state);

struct MomentumAfter {
  Vec3 momentum = Vec3::Zero();  ///< l_{n+1} [mass length^2/time]
  Mat3 slope = Mat3::Zero();     ///< by a small rotation of the orientation at t_{n+1}
};

/// turn: R_{n+1} R_n^T. `before`: of t_n, with its angular momentum also of t_n.
[[nodiscard]] MomentumAfter momentum_after(const Body& body, const BodyState& before, const Eigen::Quaterniond& turn,
                                           double dt);

}  // namespace brunt::rigid
