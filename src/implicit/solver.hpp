// SPDX-License-Identifier: Apache-2.0
// Data of implicit steps besides model, state and scratch: memory of t_n, unknowns, matrix, factors. Sized once.
#pragma once
#include <span>
#include <vector>

#include "comm/linear_system.hpp"
#include "force/trial.hpp"
#include "implicit/data/scheme.hpp"
#include "implicit/data/stiffness.hpp"
#include "implicit/data/unknowns.hpp"
#include "implicit/mortar/mortar.hpp"
#include "implicit/newton_table.hpp"
#include "implicit/rigid_bodies.hpp"
#include "implicit/stability.hpp"
#include "implicit/step_length.hpp"
#include "implicit/walls/rigid_walls.hpp"
#include "model/model.hpp"
#include "model/registry.hpp"
#include "time/links.hpp"

namespace brunt::implicit {

/// Data of t_n for the next step, three for each node: saved and hashed.
struct Memory {
  std::vector<double> internal_force;  ///< of the elements on the nodes (minus the internal force) [force]
  std::vector<double> load;            ///< gravity, pressure, dead loads; empty without loads [force]
  /// For hht, otherwise empty: now F_n + before F_{n-1} of both, which determines the acceleration [force].
  std::vector<double> inertial_internal, inertial_load;
  std::vector<double> acceleration;  ///< of newmark and hht, else empty [length/time^2]
  /// Of contact, and of its friction only; if the scene has mortar interfaces [force].
  std::vector<double> contact_force, friction_force;
  std::vector<double> wall_force, wall_friction;  ///< likewise of rigid walls, and their friction separately
  std::vector<double> wall_stiffness;  ///< of springs between nodes of rigid bodies and walls [force/length], one each
  StepLength length;
};

/// The residual at one iterate.
struct Balance {
  double left = 0;   ///< norm of the residual over all nodes, along free directions [force]
  double given = 0;  ///< norm of the applied forces: internal, loads, inertia [force]
  /// Threshold of Newton's iteration: the residual due to the rounding of positions [force].
  double rounding = 0;
};

/// The current step.
struct Trial {
  Rule rule;
  double time = 0;  ///< t_{n+1}
  double time_before = 0;
  std::vector<double> displacement;  ///< of all nodes of this rank, three each: u at the iterate
  std::vector<double> velocity;      ///< likewise v_n
  std::vector<Vec3> given;           ///< of Model::supports.nodes: Q (u_{n+1} - u_n), Q the the constrained directions
  std::vector<Vec3> given_velocity;  ///< likewise along driven axes, at t_{n+1}
  std::vector<double> contact_force, friction_force;  ///< of all nodes, three each; empty without contact [force]
  std::vector<double> wall_force, wall_friction;      ///< likewise, set when the step is accepted [force]
  Balance balance;
  std::vector<double> ratios;          ///< balance.left / balance.given, for each iterate
  std::vector<std::uint8_t> branches;  ///< of contact at the last iterate
  std::vector<std::uint8_t> stood;     ///< for each iterate: unchanged branches
  int iterate = 0;                     ///< number of residuals computed in this step
  double energy = 0;                   ///< correction . residual at the last iterate but one [energy]
};

/// Sums over contact since t = 0: saved, doubles only.
struct ContactAccount {
  double normal = 0, friction = 0;  ///< taken from the bodies [energy]
  double penetration = 0;           ///< the largest [length]
  double spin[3] = {0, 0, 0};       ///< moment of its impulses: its contribution to the angular momentum of all bodies
  double push = 0;                  ///< sum of the magnitudes of its impulses [momentum]
};
constexpr int contact_account_width = sizeof(ContactAccount) / sizeof(double);

/// Counters of this program run.
struct Work {
  GlobalIndex steps = 0, iterations = 0, most_iterations = 0, halved = 0;
  GlobalIndex contact_steps = 0;  ///< steps with contact, a tie or a wall active at their end
  double contact_seconds = 0;     ///< pairs, segments, rows, their derivatives
  double factorise_seconds = 0, tangent_seconds = 0, force_seconds = 0, solve_seconds = 0;
  double stability_seconds = 0;
  double factor_bytes = 0, factor_flops = 0;  ///< largest of one factorisation
  NewtonTable newton{};
};

struct Solver {
  model::ImplicitSolver settings;
  Unknowns unknowns;
  Stiffness stiffness;
  MortarContact contact;
  WallContact walls;
  comm::LinearSystem system;
  comm::SparseRows rows;   ///< of the whole system
  force::History history;  ///< at the iterate
  std::vector<double>
      u;  ///< Newton's unknowns: of Unknowns::node, three each [length]; own multipliers [stress]; bodies
  std::vector<LocalIndex> held;  ///< by local node: index into Model::supports.nodes, or no_index
  double support_stiffness = 0;  ///< of constrained directions in the system [force/length]
  Memory memory;
  ContactAccount contact_account;
  std::vector<double> driven;  ///< of each interface, then each wall: since when [time] and how deep [length] supports
                               ///< drive bodies through each other there, or 0: saved
  Trial trial;
  Work work;
  RigidBodies bodies{};
  Stability stability{};
};

/// The four arguments common to all functions of a step.
struct Scene {
  const model::Model& model;
  model::State& state;
  model::Scratch& scratch;
  time::Links& links;
};

/// Everything for steps from the state at t = 0, whose forces and accelerations are computed. Collective.
Solver make_solver(const Scene& scene, const model::ImplicitSolver& settings);

/// After a restart: data that follow from positions and saved arrays. Collective.
void after_restart(const Scene& scene, Solver& solver);

/// Arrays of Memory for checkpoint, restart and hash.
void add_arrays(const model::Model& model, Solver& solver, model::Registry& registry);

}  // namespace brunt::implicit
