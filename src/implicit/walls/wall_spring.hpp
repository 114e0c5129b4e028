// SPDX-License-Identifier: Apache-2.0
// A node of a rigid body at rigid walls. The pressures on several nodes of one body in one plane are statically
// indeterminate, so walls act on them by penalty springs. The force is that of the end of the step, so that springs
// never return more energy than they have stored.
#pragma once
#include "implicit/walls/wall_node.hpp"

namespace brunt::implicit {

/// pressure = - stiffness gap in penetration, or at a bilateral wall; friction as of other nodes. `left` of the action
/// is reduced by the forces, `own` is minus their derivative, `rows` is one.
/// solved: as in `act`; touching nodes are stiff in the first iterate, although they have no pressure yet.
WallAction spring(const WallQuestion& question, const WallChoice& solved);

/// Stiffness of a wall at a node, over mass/step^2 of the body. With as many active nodes as one face of the body has
/// (nodes to the power 2/3), all springs together have K dt^2/(2 m) = 2. The trapezoidal rule with the force of the end
/// then removes 1 - 1/sqrt(1 + 2) of the motion in a step, and most of it for values up to 8; with stiffer springs
/// (above 50) velocities would change their sign from step to step for a long time. The penetration under a force F is
/// F dt^2/(4 m).
constexpr double spring_at_walls = 4;

}  // namespace brunt::implicit
