// SPDX-License-Identifier: Apache-2.0
// A node of a rigid body at rigid walls. Nodes of one body in one plane hold each other: their pressures are not
// determined, so walls push them as springs do, by their penetration. The force is that of the end of the step, so
// that springs never give more than they have taken.
#pragma once
#include "brunt/implicit/wall_node.hpp"

namespace brunt::implicit {

/// pressure = - stiffness gap where it presses, or at a bilateral wall; friction as of other nodes. The action's `left`
/// has the forces taken off, `own` is their derivative with a minus, `rows` one.
/// solved: as in `act`; what touches is stiff in the first iterate, though nothing presses yet.
WallAction spring(const WallQuestion& question, const WallChoice& solved);

/// Stiffness of a wall at a node, over mass/step^2 of the body: pushed by as many nodes as one of its faces has (nodes
/// to the power 2/3), all springs together make K dt^2/(2 m) = 2. The trapezoidal rule with the force of the end takes
/// 1 - 1/sqrt(1 + 2) of the motion in a step then, and most of it up to 8; of stiffer springs (above 50) velocities
/// would change their sign from step to step for long. A force F sinks in by F dt^2/(4 m).
constexpr double spring_at_walls = 4;

}  // namespace brunt::implicit
