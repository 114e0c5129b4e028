// SPDX-License-Identifier: Apache-2.0
// One node over an accepted step: its velocity, what forces do on it, what supports give.
#pragma once
#include "brunt/implicit/solver.hpp"

namespace brunt::implicit {

/// What happened to one node in the step.
struct NodeStep {
  Vec3 travel, before, after;  ///< u_{n+1} - u_n; velocities
  Vec3 internal, load;         ///< means of the forces at t_n and t_{n+1}, which do the work
  Vec3 contact, friction;      ///< likewise; friction is a part of contact
  Vec3 wall, wall_friction;    ///< likewise
  Vec3 contact_impulse, wall_impulse;
  Vec3 internal_impulse, load_impulse;  ///< what they add to momentum
  double mass = 0;
};

/// How much of the forces of contact and walls at t_{n+1} is in the means of the step; the rest is of those at t_n.
struct EndShares {
  double of_work = 1, of_impulse = 1;
};

/// Contact acts as at the end of the step where the scheme says so, else as its mean does.
EndShares end_shares(const Rule& rule);

/// Brings node i to t_{n+1} and books what loads and supports did on it.
NodeStep commit_node(const Scene& scene, Solver& solver, std::size_t i);

}  // namespace brunt::implicit
