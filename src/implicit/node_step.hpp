// SPDX-License-Identifier: Apache-2.0
// One node over an accepted step: its velocity, the effect of forces, reactions of supports.
#pragma once
#include "implicit/solver.hpp"

namespace brunt::implicit {

/// Motion of one node and forces on it in the step.
struct NodeStep {
  Vec3 travel, before, after;  ///< u_{n+1} - u_n; velocities
  Vec3 internal, load;         ///< means of the forces at t_n and t_{n+1}, for their work
  Vec3 contact, friction;      ///< likewise; friction is a part of contact
  Vec3 wall, wall_friction;    ///< likewise
  Vec3 contact_impulse, wall_impulse;
  Vec3 internal_impulse, load_impulse;  ///< their contribution to momentum
  double mass = 0;
};

/// Weight of the forces of contact and walls at t_{n+1} in the means of the step; the rest is that of forces at t_n.
struct EndShares {
  double of_work = 1, of_impulse = 1;
};

/// The contact force is that of the end of the step if the scheme requires it, otherwise the mean.
EndShares end_shares(const Rule& rule);

/// Advances node i to t_{n+1} and adds the works of loads and supports.
NodeStep commit_node(const Scene& scene, Solver& solver, std::size_t i);

}  // namespace brunt::implicit
